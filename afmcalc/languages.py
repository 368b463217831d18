"""Which language a user is spoken to in: as asked, else as the system is set."""

import re
import sys
from collections.abc import Callable, Mapping

from .errors import AfmcalcError
from .messages import ENGLISH, FOLDER, WRITTEN, Language, known, language

OPTION, VARIABLE = "--lang", "AFMCALC_LANG"
_LOCALE = ("LC_ALL", "LC_MESSAGES", "LANG")
_OF_WINDOWS = {0x19: "ru"}
"""Number of a language in Windows, without that of the country → name."""


def of_windows() -> str:
    """Return the language of the texts of Windows; nothing of another system, whose environment tells it."""
    if sys.platform != "win32":
        return ""
    import ctypes

    return _OF_WINDOWS.get(ctypes.windll.kernel32.GetUserDefaultUILanguage() & 0x3FF, "")


def chosen(
    lang: str,
    environment: Mapping[str, str],
    note: Callable[[str], object] = lambda text: None,
    of_system: Callable[[], str] = of_windows,
) -> Language:
    """Return the language of the option, else of AFMCALC_LANG, else of the system: English where that is not known.

    Args:
        lang: language asked for by the option, if any.
        environment: variables of the process.
        note: is told that the language of the system is not spoken, as its texts are missing.
        of_system: gives the language of a system that no variable tells.

    Raises:
        AfmcalcError: what is asked for is unknown, or its texts are missing.
    """
    asked = {OPTION: lang, VARIABLE: environment.get(VARIABLE), "": _of(environment, of_system) or ENGLISH.name}
    by, name = next((by, name) for by, name in asked.items() if name)
    languages = sorted({ENGLISH.name, *WRITTEN, *known()})
    if name == ENGLISH.name:
        return ENGLISH
    if name not in languages:
        raise AfmcalcError("{by} {name:.40}: known are {languages}", by=by, name=name, languages=", ".join(languages))
    try:
        return language(name)
    except Exception as error:  # whatever is wrong with the file
        missing = AfmcalcError(
            "the texts of the language {name} cannot be read ({folder}: {file}): install afmcalc anew, "
            "or ask for --lang en",
            name=name,
            folder=FOLDER,
            file=f"{name}.mo",
        )
        if by:
            raise missing from error
        note(str(missing))
        return ENGLISH


def _of(environment: Mapping[str, str], of_system: Callable[[], str]) -> str:
    """Return the language of the system: LANGUAGE, a list, is asked first, but not where the locale is plain C."""
    locale = next(filter(None, map(environment.get, _LOCALE)), "")
    wanted = [locale] if _short(locale) in ("C", "POSIX") else [*environment.get("LANGUAGE", "").split(":"), locale]
    wanted = [_short(name) for name in wanted if name] or [of_system()]
    return next((name for name in wanted if name in (ENGLISH.name, *WRITTEN, *known())), "")


def _short(name: str) -> str:
    return re.split("[_.@]", name)[0]
