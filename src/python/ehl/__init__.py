"""Elastohydrodynamic contacts: film thickness, pressure and friction with error bars.

    import ehl
    result = ehl.run("ball.ini", motion={"u_m": 2.5})
    print(result.Hc, result.Hc.error)     # central film and its estimated relative error
    result.H[result.H.shape[0] // 2]      # film along the centre line, a view of the solver's memory
    table = ehl.sweep("ball.ini", {"motion.u_m": "0.1:10:9:log"})

The numbers are those of the program `ehl`, bit for bit: the library is the same.
"""

from ._errors import EhlError, EhlWarning, FileError, InputError, InternalError, Interrupted, NotConverged
from ._keys import Key, keys, sections
from ._result import Quantity, Result
from ._run import check, open, run, version
from ._sweep import read_table, sweep

__all__ = ["EhlError", "EhlWarning", "FileError", "InputError", "InternalError", "Interrupted", "Key", "NotConverged",
           "Quantity", "Result", "check", "keys", "open", "read_table", "run", "sections", "sweep", "version"]
