"""Load libraries that analyses load at first use, so that their loading is not counted as time of a test."""

import scipy.integrate  # noqa: F401
import scipy.stats  # noqa: F401
