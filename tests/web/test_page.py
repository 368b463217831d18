"""The page in a browser: what a person does, and what it says back."""

import json
import shlex

import pytest
from browser import browser
from pages import TABS, is_shown
from sources import SCRIPTS

pytestmark = [browser, pytest.mark.tool]
FOLD = "document.querySelectorAll('#form details').forEach(one => one.open = false)"


@pytest.fixture
def is_the_commands(afmcalc):
    """Assert that every number shown is that of the command that the copy button gives; return its result."""

    def judge(page):
        page.page.click("#copy")
        page.page.wait_for_function("async () => (await navigator.clipboard.readText()).startsWith('afmcalc')")
        command = page.page.evaluate("navigator.clipboard.readText()")
        assert command == page.page.inner_text("#command").strip()
        result = afmcalc(*shlex.split(command)[1:], "--json").json["result"]
        is_shown(page.cells, result)
        return result

    return judge


def slide(page, key, share):
    """Set the slider of a field to a share of its range as a mouse does; return the text of the field."""
    page.page.locator(f'[data-of="{key}"]').evaluate(SCRIPTS["slide"], share)
    return page.field(key).input_value()


def test_a_slider_moves_the_accuracy_factor(opened, served, is_the_commands):
    page = opened(served)
    before = page.cells["accuracy_factor"]
    gain = slide(page, "control_unit.gain", 0.8)
    assert gain != "0.5"
    page.answered(f"control_unit.gain={gain}")
    result = is_the_commands(page)
    assert result["gain"] == float(gain)
    assert page.cells["accuracy_factor"] != before
    assert f"{result['accuracy_factor']:.5g}" in page.page.inner_text("#numbers")
    page.put("closing_spring.force", "1800 N")
    assert slide(page, "closing_spring.force", 0.5) == "1800 N", "a slider keeps the unit that was written"


def test_the_verdict_of_an_event_comes_by_itself(opened, serve, afmcalc):
    """It follows the verdict given at once, and is that of the last of several changes."""
    served = serve("drive")
    page = opened(served)
    for gain in ("0.6", "0.7"):
        page.field("control_unit.gain").fill(gain)
        page.answered(f"control_unit.gain={gain}")
    page.page.wait_for_function("() => !document.querySelector('#verdict .said')")
    verdict = afmcalc("check", served.spec, "--set", "control_unit.gain=0.7", "--json").json["result"]["verdict"]
    said = page.page.inner_text("#verdict .sum")
    assert said.replace("\N{NO-BREAK SPACE}", " ") == verdict["sentence"].replace("\N{NO-BREAK SPACE}", " ")
    assert said in page.page.inner_text("#status")


def focus(page, selector, most=400):
    """Press Tab until an element has the focus; assert that it is reached and that the focus is visible."""
    for _ in range(most):
        if page.page.evaluate("selector => document.activeElement.matches(selector)", selector):
            shown = "(s => s.outlineStyle != 'none' && s.outlineWidth != '0px' || s.boxShadow != 'none')(getComputedStyle(document.activeElement))"
            assert page.page.evaluate(shown), f"the focus on {selector} is not seen"
            return
        page.page.keyboard.press("Tab")
    raise AssertionError(f"{selector} is not reached with Tab")


def test_without_a_mouse(opened, served):
    """By keyboard alone one can reach a field, change it, move its slider, switch tabs, pin and save."""
    page = opened(served)
    keyboard = page.page.keyboard
    focus(page, '[name="control_unit.gain"]')
    keyboard.press("Control+a")
    keyboard.type("0.7")
    page.answered("gain=0.7")
    focus(page, '[data-of="control_unit.gain"]')
    keyboard.press("ArrowRight")
    moved = page.field("control_unit.gain").input_value()
    assert 0.7 < float(moved) < 0.9
    page.answered(f"gain={moved}")
    focus(page, "#tab-accuracy")
    keys = ("ArrowRight", "End", "ArrowRight", "ArrowLeft", "Home", "ArrowRight")
    for key, name in zip(keys, (1, -1, 0, -1, 0, 1), strict=True):
        keyboard.press(key)
        assert page.page.evaluate("document.activeElement.id") == f"tab-{TABS[name]}"
    keyboard.press("Enter")
    assert page.page.get_attribute("#tab-drive", "aria-selected") == "true"
    assert page.page.is_visible("#panel-drive")
    assert not page.page.is_visible("#panel-accuracy")
    page.page.evaluate("document.activeElement.blur()")
    focus(page, "#pin")
    keyboard.press("Space")
    page.page.wait_for_function("() => document.querySelector('#compare').textContent.trim() != ''")
    keyboard.press("Space")
    page.page.wait_for_function("() => document.querySelector('#compare').textContent.trim() == ''")
    before = served.spec.read_bytes()
    focus(page, "#save")
    keyboard.press("Enter")
    page.page.wait_for_function("() => document.querySelector('#status').textContent.includes('clutch.toml')")
    assert f"gain = {moved}".encode() in served.spec.read_bytes()
    served.spec.write_bytes(before)


def test_nothing_leaves_the_page_and_nothing_comes_in(opened, served, chromium):
    """Every request goes to the server; only the page's own script runs; no other page reads or frames it."""
    page = opened(served)
    page.open("report")
    assert page.requests
    assert not [url for url in page.requests if not url.startswith((served.url, "data:", "about:srcdoc", "blob:"))]
    assert not page.page.evaluate("document.cookie")
    assert page.problems == []
    assert page.page.evaluate(SCRIPTS["injected"]) == [None, "refused"]
    assert any("Content Security Policy" in text for text in page.problems)
    page.problems.clear()
    other = chromium.new_page()
    other.route("http://evil.example/", lambda route: route.fulfill(body="<p>hello", content_type="text/html"))
    other.goto("http://evil.example/")
    assert other.evaluate(SCRIPTS["asking"], served.url) == [0, 0]
    other.set_content(f'<iframe src="{served.url}" width="900" height="600"></iframe>')
    other.wait_for_timeout(500)
    assert not other.frames[-1].query_selector("form")
    other.close()


def test_a_tab_begins_though_the_one_before_answers_as_it_is_opened(opened, served):
    """The first tab's answer, which comes just after another is opened, does not end that one's beginning."""
    page = opened(served)
    held = []
    page.page.route("**/tab/accuracy", lambda route: held.append((route, route.fetch())))
    page.put("control_unit.gain", "1.01")
    page.page.wait_for_function("() => document.querySelector('#panel-accuracy').ariaBusy == 'true'")
    while not held:
        page.page.wait_for_timeout(20)
    page.page.click("#tab-report")
    route, response = held.pop()
    route.fulfill(response=response)
    page.page.wait_for_selector("#panel-report .answer > *", state="attached")


def test_a_burst_ends_with_the_last_state(opened, served, is_the_commands):
    """No older answer replaces the last state, another tab does not change it, and it survives a reload."""
    page = opened(served)
    page.tab().fill('[name="control_unit.gain"]', "0.9")
    last = page.page.evaluate(SCRIPTS["burst"])
    page.answered(f"gain={last}")
    assert is_the_commands(page)["gain"] == float(last)
    page.page.wait_for_timeout(300)
    assert page.cells["gain"] == repr(float(last))
    page.page.reload()
    page.answered(f"gain={last}")
    assert page.field("control_unit.gain").input_value() == last
    is_the_commands(page)


WIDE = "document.documentElement.scrollWidth"
SHOWN = {"drive": ("en", "dark", ["heat"]), "indirect": ("ru", "light", ["accuracy", "report"])}


@pytest.mark.parametrize("name", SHOWN)
def test_it_is_accessible_and_fits_a_telephone(opened, serve, name):
    """axe-core finds no serious fault with everything unfolded, in tabs, with a pinned state and with an error."""
    language, scheme, tabs = SHOWN[name]
    page = opened(serve(name, "--lang", language), scheme=scheme, width=375)
    assert page.page.get_attribute("html", "lang") == language
    page.unfold()
    assert page.page.evaluate(SCRIPTS["unnamed"]) == []
    assert page.page.get_attribute("#status", "role") == "status"
    page.page.click("#pin")
    faults = {"form": page.axe()}
    page.page.evaluate(FOLD)
    for tab in tabs:
        page.open(tab)
        assert page.page.evaluate(WIDE) <= 375, tab
        faults[tab] = page.axe()
    page.put("control_unit.gain", "wrong unit here which is long")
    page.told("control_unit.gain")
    assert page.field("control_unit.gain").get_attribute("aria-invalid") == "true"
    assert "error-control_unit.gain" in page.field("control_unit.gain").get_attribute("aria-describedby").split()
    assert page.page.evaluate(WIDE) <= 375
    faults["error"] = page.axe()
    assert not any(faults.values()), json.dumps(faults, indent=1, ensure_ascii=False)
