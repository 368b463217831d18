"""The languages people may be spoken to in: catalogue, plural rule and the signs of numbers.

English needs nothing of it. A catalogue is a file of gettext, ``locale/NAME.po``, read as it is.
"""

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

FOLDER = os.path.join(os.path.dirname(__file__), "locale")


@dataclass(frozen=True)
class Language:
    """What it takes to say something in a language."""

    name: str
    catalogue: Mapping[tuple[str, str], tuple[str, ...]]
    """Context and English text → the text, or its plural forms."""
    form: Callable[[int], int]
    """Count → which of the plural forms."""
    signs: Mapping[int, str]
    """Sign of a number as Python writes it → as people do."""

    def found(self, text: str, context: str = "", count: int = 1) -> str | None:
        """Return the text that stands for an English one, in its form for a count; None where there is none."""
        forms = self.catalogue.get((context, text)) or self.catalogue.get((context or "value", text))
        return None if forms is None else forms[self.form(count) if len(forms) > 1 else 0]


def known() -> list[str]:
    """Names of the languages that there is a catalogue of."""
    return sorted(name.removesuffix(".po") for name in os.listdir(FOLDER) if name.endswith(".po"))


def language(name: str) -> Language:
    """Return a language by its name."""
    return Language(name, *_read(name))


@cache
def _read(
    name: str,
) -> tuple[Mapping[tuple[str, str], tuple[str, ...]], Callable[[int], int], Mapping[int, str]]:
    from gettext import c2py

    from babel import Locale
    from babel.messages.pofile import read_po

    with open(os.path.join(FOLDER, f"{name}.po"), "rb") as file:
        catalogue = read_po(file, abort_invalid=True)
    texts = {}
    for each in catalogue:
        # one with a plural is looked up by its singular
        key, *_ = [each.id] if isinstance(each.id, str) else each.id
        forms = (each.string,) if isinstance(each.string, str) else tuple(each.string or ())
        if key and all(forms):
            texts[each.context or "", key] = forms
    symbols = Locale.parse(name).number_symbols["latn"]
    signs = str.maketrans({".": symbols["decimal"], ",": symbols["group"]})
    return texts, c2py(catalogue.plural_expr), signs
