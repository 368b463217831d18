"""Libraries that analyses load when they need them are loaded here, not in the time of the first test that does."""

import scipy.integrate  # noqa: F401
import scipy.stats  # noqa: F401
