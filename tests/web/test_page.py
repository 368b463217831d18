"""The page in a browser: what a person does, and what it says back."""

import json
import random
import shlex
import tomllib

import pytest
from browser import browser
from conftest import several
from serving import CONFIGS, at, command_line, proc, spec_in, until
from test_live import VARIANTS, changed, texts

pytestmark = browser
TABS = ["accuracy", "drive", "heat", "tolerance", "design", "explanation", "report"]
MIB = 1 << 20


def equals_the_command(page):
    """Every number shown is the command's that the copy button gives."""
    command = page.copied()
    assert command == page.page.inner_text("#command").strip()
    run = command_line(*shlex.split(command)[1:], "--json", folder=page.served.folder)
    assert run.returncode == 0, run.stderr
    result, shown = json.loads(run.stdout)["result"], page.cells
    assert len(shown) >= 10
    for path, text in shown.items():
        expected = at(result, path)
        assert expected is None if not text else float(text) == expected, path
    return result


def slide(slider, share):
    """Set a slider as a mouse does, to a share of its way."""
    return slider.evaluate(
        """(slider, share) => {
          slider.value = Number(slider.min) + share * (slider.max - slider.min)
          slider.dispatchEvent(new Event('input', {bubbles: true}))
          slider.dispatchEvent(new Event('change', {bubbles: true}))
          return slider.value }""",
        share,
    )


def test_a_slider_moves_the_accuracy_factor(opened, served):
    page = opened(served)
    before = float(page.cells["accuracy_factor"])
    slide(page.slider("control_unit.gain"), 0.8)
    gain = page.field("control_unit.gain").input_value()
    assert gain != "0.5"
    page.answered(f"control_unit.gain={gain}")
    result = equals_the_command(page)
    assert result["gain"] == float(gain)
    assert float(page.cells["accuracy_factor"]) == result["accuracy_factor"] != before
    assert f"{result['accuracy_factor']:.5g}" in page.page.inner_text("#numbers")
    slide(page.slider("closing_spring.force"), 0.5)
    force = page.field("closing_spring.force").input_value()
    assert force.endswith(" kN"), "a slider keeps the unit that was written"
    page.answered(f"closing_spring.force={force}")
    assert equals_the_command(page)["closing_force"] == pytest.approx(1e3 * float(force.split()[0]))
    assert page.problems == []


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", VARIANTS)
def test_any_state_is_the_commands(opened, serve, tmp_path, name):
    """Sliders and fields of a few numbers, twice for each variant: fourteen states."""
    spec = spec_in(tmp_path, name)
    page = opened(serve(spec.name))
    given = texts(tomllib.loads(spec.read_text(encoding="utf-8")))
    draw, right = random.Random(name), 0
    for _ in range(12):
        key = draw.choice(sorted(given))
        if not page.field(key).count():
            continue
        slider = page.slider(key)
        if slider.count() and slider.is_enabled() and draw.random() < 0.5:
            page.unfold()
            slide(slider, draw.uniform(0.3, 0.7))
        else:
            page.put(key, changed(given[key], draw.uniform(0.9, 1.1)))
        text = page.field(key).input_value()
        page.settled()
        if page.page.locator("[aria-invalid=true]").count() or page.page.locator("#live.stale").count():
            page.put(key, given[key])
            page.settled()
            continue
        assert text == given[key] or f"{key}={text}" in page.page.inner_text("#command")
        equals_the_command(page)
        right += 1
    assert right >= 2
    assert page.problems == []


MISTAKES = [
    ("closing_spring.force", "2 s"),
    ("control_unit.gain", "O.5"),
    ("control_unit.wall_angle", "95 deg"),
    ("friction_group.inner_radius", "80 mm"),
    ("friction.min", ""),
]
"""A unit that is wrong, a number misspelt, out of bounds, a contradiction, one missing."""


def test_errors_stand_at_their_field(opened, served):
    page = opened(served)
    before = page.cells
    for key, text in several(MISTAKES[:2], MISTAKES):
        page.unfold()
        was = page.field(key).input_value()
        page.put(key, text)
        said = page.told(key)
        run = command_line("torque", "clutch.toml", "--set", f"{key}={text}", folder=served.folder)
        assert any(line.endswith(said) for line in run.stderr.splitlines()), (said, run.stderr)
        assert page.field(key).get_attribute("aria-invalid") == "true"
        assert f"error-{key}" in page.field(key).get_attribute("aria-describedby").split()
        assert page.cells == before, "the last numbers stay"
        page.put(key, was)
        page.page.wait_for_function("key => !document.getElementById(`error-${key}`).checkVisibility()", arg=key)
        assert page.field(key).get_attribute("aria-invalid") in (None, "false")
    assert page.problems == []


@pytest.mark.exhaustive
def test_a_variant_is_chosen(opened, served):
    """Nothing a form can hold is lost: what the other variant lacks is said where it is missing."""
    page = opened(served)
    page.put("variant", "all-driving")
    page.page.wait_for_function(
        "() => document.querySelector('[aria-invalid=true]') || document.querySelector('#command').textContent.includes('all-driving')"
    )
    if page.page.locator("[aria-invalid=true]").count():
        page.put("friction_group.driving_pairs", "")
    page.answered("all-driving")
    equals_the_command(page)
    page.put("variant", "indirect")
    assert "indirect" in page.told("control_unit.key_friction")
    assert page.problems == []


def test_a_state_is_pinned_and_compared(opened, served):
    page = opened(served)
    before = page.page.locator('#numbers [data-path="accuracy_factor"]').inner_text()
    page.page.click("#pin")
    page.put("control_unit.gain", "0.8")
    page.answered("gain=0.8")
    compared = page.page.inner_text("#compare")
    assert "0.5" in compared
    assert "0.8" in compared
    assert before in page.page.inner_text("#numbers")
    equals_the_command(page)
    page.page.click("#pin")
    page.page.wait_for_function("() => document.querySelector('#compare').textContent.trim() == ''")
    assert page.problems == []


def focus(page, selector, most=400):
    """Press Tab until something has the focus; nothing on the way swallows the key."""
    for _ in range(most):
        if page.page.evaluate("selector => document.activeElement.matches(selector)", selector):
            shown = "(s => s.outlineStyle != 'none' && s.outlineWidth != '0px' || s.boxShadow != 'none')(getComputedStyle(document.activeElement))"
            assert page.page.evaluate(shown), f"the focus on {selector} is not seen"
            return
        page.page.keyboard.press("Tab")
    raise AssertionError(f"{selector} is not reached with Tab")


def test_without_a_mouse(opened, forced, spec):
    """Reach a field, change it, move its slider, switch tabs, pin, save."""
    page = opened(forced)
    keyboard = page.page.keyboard
    focus(page, '[name="control_unit.gain"]')
    keyboard.press("Control+a")
    keyboard.type("0.7")
    page.answered("gain=0.7")
    focus(page, '[name="control_unit.gain"] ~ input[type=range]')
    keyboard.press("ArrowRight")
    keyboard.press("ArrowRight")
    moved = page.field("control_unit.gain").input_value()
    assert 0.7 < float(moved) < 0.9
    page.answered(f"gain={moved}")
    focus(page, "#tab-accuracy")
    for key, name in (
        ("ArrowRight", "drive"),
        ("ArrowRight", "heat"),
        ("End", "report"),
        ("ArrowRight", "accuracy"),
        ("ArrowLeft", "report"),
        ("Home", "accuracy"),
    ):
        keyboard.press(key)
        assert page.page.evaluate("document.activeElement.id") == f"tab-{name}"
    keyboard.press("ArrowRight")
    keyboard.press("Enter")
    assert page.page.get_attribute("#tab-drive", "aria-selected") == "true"
    assert page.page.is_visible("#panel-drive")
    assert not page.page.is_visible("#panel-accuracy")
    keyboard.press("Tab")
    assert page.page.evaluate("document.activeElement.closest('[role=tabpanel], [role=tablist]')?.id ?? ''") != ""
    keyboard.press("Control+Home")
    page.page.evaluate("document.activeElement.blur()")
    focus(page, "#pin")
    keyboard.press("Space")
    page.page.wait_for_function("() => document.querySelector('#compare').textContent.trim() != ''")
    focus(page, "#save")
    keyboard.press("Enter")
    page.page.wait_for_function("() => document.querySelector('#status').textContent.includes('clutch.toml')")
    assert tomllib.loads(spec.read_text(encoding="utf-8"))["control_unit"]["gain"] == float(moved)
    assert page.problems == []


def test_nothing_leaves_the_page(opened, served):
    """Every request goes where the page is from, and none is refused by its policy."""
    page = opened(served)
    for name in several(["accuracy", "explanation"], TABS):
        page.open(name, 60)
    page.put("control_unit.gain", "0.6")
    page.answered("gain=0.6")
    assert page.requests
    assert not [url for url in page.requests if not url.startswith((served.url, "data:", "about:srcdoc", "blob:"))]
    assert page.problems == []
    assert not page.page.evaluate("document.cookie")


def test_the_policy_holds(opened, served):
    """Neither a script in the page nor one from elsewhere is run, nothing is loaded from elsewhere."""
    page = opened(served)
    ran = page.page.evaluate(
        """async () => {
          const inline = document.createElement('script')
          inline.textContent = 'window.ran = 1'
          document.body.append(inline)
          const div = document.createElement('div')
          div.innerHTML = '<img src=x onerror="window.ran = 2"><svg onload="window.ran = 3"></svg>'
          document.body.append(div)
          const there = await fetch('http://127.0.0.1:9/').then(() => 'loaded', () => 'refused')
          await new Promise(done => setTimeout(done, 200))
          return [window.ran ?? null, there]
        }"""
    )
    assert ran == [None, "refused"]
    assert any("Content Security Policy" in text for text in page.problems)


@pytest.mark.exhaustive
def test_it_cannot_be_framed(opened, served, chromium, tmp_path):
    page = chromium.new_page()
    page.set_content(f'<iframe src="{served.url}" width="900" height="600"></iframe>')
    page.wait_for_timeout(500)
    assert not page.frames[-1].query_selector("form")
    page.close()


def test_another_page_reads_nothing(served, chromium):
    """A page of another origin, in the same browser, knowing even the token."""
    page = chromium.new_page()
    page.route("http://evil.example/", lambda route: route.fulfill(body="<p>hello", content_type="text/html"))
    page.goto("http://evil.example/")
    asking = """async url => {
      const outcomes = []
      for (const [method, mode, type] of [['GET', 'cors'], ['GET', 'no-cors'], ['POST', 'cors', 'application/json'], ['POST', 'no-cors', 'text/plain']]) {
        try {
          const reply = await fetch(url + (method == 'POST' ? 'live' : ''),
            {method, mode, body: method == 'POST' ? '{"base": 0, "fields": {}}' : undefined, headers: type ? {'Content-Type': type} : {}})
          outcomes.push((await reply.text()).length)
        } catch { outcomes.push(0) }
      }
      return outcomes
    }"""
    assert page.evaluate(asking, served.url) == [0, 0, 0, 0]
    page.close()


def at_rest(served):
    """Memory once nothing is calculated, and a process that took another's place is warm."""
    until(lambda: served.busy(1) < 0.05, 60)
    return served.memory()


@proc
@pytest.mark.exhaustive
def test_a_burst_ends_with_the_last_state(opened, served):
    """Changes faster than they are answered: memory stays, the last one is shown."""
    page = opened(served)
    burst = """async ([count, from]) => {
      const field = document.querySelector('[name="control_unit.gain"]')
      for (let number = 1; number <= count; number++) {
        field.value = (from + 0.3 * number / count).toFixed(4)
        field.dispatchEvent(new Event('input', {bubbles: true}))
        await new Promise(done => setTimeout(done, 5))
      }
      return field.value
    }"""
    last = page.page.evaluate(burst, [50, 0.2])
    page.answered(f"gain={last}")
    before = at_rest(served)
    last = page.page.evaluate(burst, [several(100, 950), 0.3])
    page.answered(f"gain={last}")
    assert at_rest(served) - before < 20 * MIB
    result = equals_the_command(page)
    assert result["gain"] == float(last)
    page.page.wait_for_timeout(300)
    assert page.cells["gain"] == repr(float(last)), "no older answer comes after it"
    assert page.problems == []


@pytest.mark.exhaustive
def test_two_tabs_do_not_disturb_each_other(opened, served):
    first = opened(served)
    other = first.tab()
    first.put("control_unit.gain", "0.3")
    other.fill('[name="control_unit.gain"]', "0.9")
    first.answered("gain=0.3")
    other.wait_for_function("() => document.querySelector('#command').textContent.includes('gain=0.9')")
    assert first.cells["gain"] == "0.3"
    assert other.get_attribute('#numbers [data-path="gain"]', "data-value") == "0.9"
    assert first.page.get_attribute('#numbers [data-path="gain"]', "data-value") == "0.3"
    assert first.problems == []


@pytest.mark.exhaustive
def test_what_was_typed_survives_a_reload(opened, served):
    page = opened(served)
    page.put("control_unit.gain", "0.65")
    page.answered("gain=0.65")
    page.page.reload()
    page.answered("gain=0.65")
    assert page.field("control_unit.gain").input_value() == "0.65"
    equals_the_command(page)


@pytest.mark.exhaustive
def test_a_point_of_the_front_is_loaded(opened, served):
    """The form becomes its clutch; what is shown is what a command gives."""
    page = opened(served)
    page.page.click("#tab-design")
    page.page.fill("#requirements", (CONFIGS / "requirements.toml").read_text(encoding="utf-8"))
    page.page.click("#panel-design .start")
    page.page.wait_for_selector("#panel-design [data-base]", timeout=60_000)
    before = page.cells
    page.page.locator("#panel-design [data-base]").first.click()
    page.page.wait_for_function(
        "was => document.querySelector('[data-path=accuracy_factor]').dataset.value != was",
        arg=before["accuracy_factor"],
    )
    gain = page.field("control_unit.gain").input_value()
    assert page.cells["gain"]
    assert gain == "" or float(gain) == pytest.approx(float(page.cells["gain"]), rel=1e-9)
    page.unfold()
    page.put("friction_group.pairs", "6")
    page.answered("pairs=6")
    assert page.problems == []


@pytest.mark.exhaustive
def test_a_server_that_is_gone_is_said(opened, serve, tmp_path):
    page = opened(serve(spec_in(tmp_path).name))
    page.served.end()
    page.put("control_unit.gain", "0.6")
    page.page.wait_for_function("() => document.querySelector('#status').textContent.length > 20")
    assert page.field("control_unit.gain").input_value() == "0.6"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("name", "language"), [("default", "en"), ("drive", "en"), ("indirect", "ru")])
@pytest.mark.every(6)
def test_it_is_accessible(opened, served, serve, tmp_path, name, language, scheme):
    """axe-core finds nothing serious in any tab, with all unfolded, a state pinned, and an error shown."""
    server = served if name == "default" else serve(spec_in(tmp_path, name).name, "--lang", language)
    page = opened(server, scheme=scheme)
    page.unfold()
    page.page.click("#pin")
    faults = {}
    for tab in several([], TABS):
        page.open(tab, 120)
        faults[tab] = page.axe()
    page.put("control_unit.gain", "wrong")
    page.told("control_unit.gain")
    faults["error"] = page.axe()
    assert page.problems == []
    assert not any(faults.values()), json.dumps(faults, indent=1, ensure_ascii=False)


def test_every_field_has_a_name_of_its_own(opened, served):
    """For a screen reader: labels, not only places."""
    page = opened(served)
    page.unfold()
    unnamed = """[...document.querySelectorAll('input:not([type=hidden]), select, textarea, button')].filter(one =>
      !(one.labels?.length && [...one.labels].some(label => label.textContent.trim())) && !one.getAttribute('aria-label')
      && !one.textContent.trim() && !one.getAttribute('aria-labelledby')).map(one => one.outerHTML)"""
    assert page.page.evaluate(unnamed) == []
    twice = "(ids => ids.filter((id, at) => ids.indexOf(id) != at))([...document.querySelectorAll('[id]')].map(one => one.id))"
    assert page.page.evaluate(twice) == []
    assert page.page.get_attribute("#status", "aria-live") or page.page.get_attribute("#status", "role") == "status"


def test_a_telephone_shows_it_without_scrolling_sideways(opened, served):
    page = opened(served, width=375)
    page.unfold()
    assert page.page.evaluate("document.documentElement.scrollWidth") <= 375


@pytest.mark.exhaustive
@pytest.mark.parametrize("language", ["ru", "en"])
def test_a_telephone_shows_every_tab(opened, serve, tmp_path, language):
    page = opened(serve(spec_in(tmp_path, "indirect").name, "--lang", language), width=375)
    assert page.page.get_attribute("html", "lang") == language
    page.unfold()
    wide = "document.documentElement.scrollWidth"
    assert page.page.evaluate(wide) <= 375
    for tab in TABS:
        page.open(tab, 120)
        assert page.page.evaluate(wide) <= 375, tab
    page.page.click("#pin")
    page.put("control_unit.gain", "wrong unit here which is long")
    page.told("control_unit.gain")
    assert page.page.evaluate(wide) <= 375
    assert page.problems == []


@pytest.mark.exhaustive
def test_it_speaks_russian(opened, serve, tmp_path):
    page = opened(serve(spec_in(tmp_path).name, "--lang", "ru"))
    for text in page.page.locator(
        "button:visible, summary:visible, [role=tab]:visible, caption:visible"
    ).all_inner_texts():
        assert any("а" <= letter <= "я" for letter in text.lower()), text
    page.put("control_unit.gain", "x")
    said = page.told("control_unit.gain")
    run = command_line("torque", "clutch.toml", "--set", "control_unit.gain=x", "--lang", "ru", folder=tmp_path)
    assert any(line.endswith(said) for line in run.stderr.splitlines()), (said, run.stderr)
