"""What the papers say: formulas, misprints and claims (one list each), and what recomputes claims and figures."""

PAPERS = {"F11": "fokin2011", "S19": "shishkarev2019", "S21": "shishkarev2021", "S22": "shishkarev2022"}
"""Key of a paper → module of its figures and claims."""

REFERENCES = {
    "F11": "Фокин А.Е., Гавриленко М.Д., Шишкарев М.П. Исследование адаптивной фрикционной муфты с дифференцированными "
    "парами трения. Вестник ДГТУ, 2011, т. 11, № 1 (52), с. 49–56.",
    "S19": "Шишкарёв М.П. Влияние способа настройки АФМ на величину изменения передаваемой нагрузки (2019).",
    "S21": "Шишкарев М.П. Синтез АФМ первого поколения с косвенным регулированием (2021).",
    "S22": "Шишкарев М.П. Уровень перегрузок в приводе машины с АФМ со всеми ведущими парами трения (2022).",
    "CJ": "Carslaw H.S., Jaeger J.C. Conduction of Heat in Solids. 2nd ed. Oxford, 1959.",
    "Di17": "DIN EN 16984. Disc springs – Calculation. 2017.",
    "En13": "EN 13906-1. Cylindrical helical springs made from round wire and bar – Compression springs. 2013.",
    "Sh11": "Budynas R.G., Nisbett J.K. Shigley's Mechanical Engineering Design. 9th ed., McGraw-Hill, 2011.",
    "Fi68": "Finkin E.F. Spline friction in multiple disc clutches. J. Lubrication Technology 90 (1968) 65.",
}
"""Key → reference, as the formulas cite them."""
