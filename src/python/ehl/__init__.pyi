"""Elastohydrodynamic contacts. Made from the records of the program's keys by `python3 -m ehl._stubs`."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypedDict

import numpy as np
import pandas as pd

Deck = str | os.PathLike[str] | Mapping[str, Mapping[str, Any]]

class EhlError(Exception):
    messages: list[str]
    result: Result | None

class InputError(EhlError, ValueError): ...
class NotConverged(EhlError, RuntimeError): ...
class FileError(EhlError, OSError): ...
class Interrupted(EhlError, RuntimeError): ...
class InternalError(EhlError, RuntimeError): ...
class EhlWarning(UserWarning): ...

class Quantity(float):
    name: str
    unit: str
    meaning: str
    error: float | None
    """Estimated relative error."""
    @property
    def bar(self) -> float | None: ...

class Result:
    path: str | None
    @property
    def status(self) -> int: ...
    @property
    def converged(self) -> bool: ...
    @property
    def messages(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def report(self) -> str: ...
    @property
    def json(self) -> dict[str, Any] | None: ...
    @property
    def quantities(self) -> dict[str, Quantity]: ...
    @property
    def fields(self) -> dict[str, np.ndarray]: ...
    def table(self, name: str) -> pd.DataFrame: ...
    def save(self, path: str | os.PathLike[str], overwrite: bool = False) -> None: ...
    def __getitem__(self, path: str) -> Any: ...
    def __getattr__(self, name: str) -> Any: ...
    def __contains__(self, path: str) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...

class Key:
    section: str
    name: str
    type: str
    unit: str
    default: str
    default_note: str
    allowed: str
    words: tuple[str, ...]
    needs: str
    meaning: str
    source: str
    example: str

def open(path: str | os.PathLike[str], case: int | None = None) -> Result: ...
def keys(selection: str | None = None) -> list[Key]: ...
def sections() -> dict[str, str]: ...
def version() -> str: ...
def read_table(path: str | os.PathLike[str]) -> pd.DataFrame: ...

class CaseKeys(TypedDict, total=False):
    """What this case is called, and of what kind it is."""
    title: str | os.PathLike[str]
    """Title of the case, on the report and the pictures.
    default: untitled; allowed: any text"""
    kind: Literal["lubricated", "dry", "ball_race", "roller_race", "gear_mesh"]
    """ball_race, roller_race, gear_mesh: radii, speeds and load of [contact] and [motion] follow from [bearing] or [gear]; E' and the oil are given as ever. dry: the bodies touch without lubricant, Hertz' contact with whatever the surfaces carry. Then [contact] has load, radius_x and the elastic data, or nothing (in units of Hertz), and no key is allowed that speaks of a film.
    default: lubricated; allowed: one of lubricated, dry, ball_race, roller_race, gear_mesh"""

class BearingKeys(TypedDict, total=False):
    """A ball or a roller on its race. Only with [case] kind = ball_race or roller_race."""
    diameter: float | str
    """Diameter D of ball or roller. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 m"""
    pitch_diameter: float | str
    """Diameter d_m of the circle of their centres; half the sum of bore and outside diameter, nearly. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 m"""
    race: Literal["inner", "outer"]
    """The race whose contact is computed. (only with [case] kind = ball_race or roller_race)
    default: inner; allowed: one of inner, outer"""
    conformity: float | str
    """Groove conformity f, the groove's radius over the diameter of the ball. (only with [case] kind = ball_race)
    default: 0.52; allowed: a number > 0.5 and <= 1"""
    contact_angle: float | str
    """Contact angle alpha between the load on the ball and the radial plane, at both races. (only with [case] kind = ball_race)
    default: 0; allowed: a number >= 0 and < 90 degrees"""
    length: float | str
    """Length of a cylindrical roller that touches the race. (only with [case] kind = roller_race)
    default: none; allowed: a number > 0 m"""
    load: float | str
    """Load Q on the ball or roller; or radial_load. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 N"""
    radial_load: float | str
    """Radial load F_r on the bearing. Its elements carry it in static equilibrium, with rigid rings and no clearance: Q grows with the power 3/2 of the deflection of balls, 10/9 of rollers. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 N"""
    elements: int
    """Number Z of balls or rollers. (only with [bearing] radial_load)
    default: none; allowed: a whole number >= 3 and <= 1000"""
    azimuth: float | str
    """Where the ball or roller stands, from the direction of the radial load: 0 carries most. (only with [bearing] radial_load)
    default: 0; allowed: a number >= -180 and <= 180 degrees"""
    rpm_inner: float | str
    """Speed of the inner ring. One ring alone: the other stands still; or two of the three. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number >= -1e+06 and <= 1e+06 1/min"""
    rpm_outer: float | str
    """Speed of the outer ring, positive in the same sense of rotation. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number >= -1e+06 and <= 1e+06 1/min"""
    rpm_cage: float | str
    """Speed of the cage, which follows from both rings. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number >= -1e+06 and <= 1e+06 1/min"""

class GearKeys(TypedDict, total=False):
    """Two spur gears. Only with [case] kind = gear_mesh."""
    module: float | str
    """Module m of both wheels. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 m"""
    teeth1: int
    """Teeth z1 of wheel 1, which drives: contact begins at its root. (only with [case] kind = gear_mesh)
    default: none; allowed: a whole number >= 3 and <= 10000"""
    teeth2: int
    """Teeth z2 of wheel 2. (only with [case] kind = gear_mesh)
    default: none; allowed: a whole number >= 3 and <= 10000"""
    pressure_angle: float | str
    """Pressure angle alpha of the basic rack. (only with [case] kind = gear_mesh)
    default: 20; allowed: a number >= 5 and <= 45 degrees"""
    shift1: float | str
    """Profile shift coefficient x1. The tips are shortened so that their clearance stays. (only with [case] kind = gear_mesh)
    default: 0; allowed: a number >= -2 and <= 2"""
    shift2: float | str
    """Profile shift coefficient x2. (only with [case] kind = gear_mesh)
    default: 0; allowed: a number >= -2 and <= 2"""
    addendum: float | str
    """Addendum over the module, before profile shift alters it. (only with [case] kind = gear_mesh)
    default: 1; allowed: a number > 0 and <= 3"""
    face_width: float | str
    """Width b of the faces that touch. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 m"""
    power: float | str
    """Power; or torque1. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 W"""
    torque1: float | str
    """Torque of wheel 1. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 N m"""
    rpm1: float | str
    """Speed of wheel 1. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 and <= 1e+06 1/min"""
    position: float | str
    """Where the teeth touch, along the path of contact: 0 where contact begins, at the tip of wheel 2; 1 where it ends, at the tip of wheel 1. (only with [case] kind = gear_mesh)
    default: the pitch point, where that lies on the path; allowed: a number >= 0 and <= 1"""
    sharing: Literal["none", "linear"]
    """How two pairs of teeth share the load. linear: teeth of equal stiffness without relief of their tips, from 1/3 where contact begins to 2/3, 1 where one pair is alone, from 2/3 to 1/3 at the end; for a contact ratio below 2. none: every pair carries all. (only with [case] kind = gear_mesh)
    default: linear; allowed: one of none, linear"""

class ContactKeys(TypedDict, total=False):
    """The contact, in ONE of three languages: M and L (Moes); W, U and G (Hamrock and Dowson); or SI: load, radius_x and the elastic data."""
    kind: Literal["point", "line", "roller"]
    """point: a circle or an ellipse. line: bodies that are long and straight across the motion, as gear teeth and cams; nothing changes along y, and all that is a force is per length. Then M = W (2U)^(-1/2) and W = F'/(E' R_x), with F' the load per length. roller: a piece of such a contact, length long, with the profile of [roller]; M and W are those of its mean load per length.
    default: point; allowed: one of point, line, roller"""
    M: float | str
    """Moes load number M = W (2U)^(-3/4). First language: M and L.
    default: none; allowed: a number >= 0.1 and <= 1e+05"""
    L: float | str
    """Moes material number L = G (2U)^(1/4); 0 for an isoviscous lubricant.
    default: none; allowed: a number >= 0 and <= 100"""
    W: float | str
    """Hamrock-Dowson load number W = F/(E' R_x^2). Second language: W, U and G.
    default: none; allowed: a number > 0"""
    U: float | str
    """Hamrock-Dowson speed number U = eta0 u_m/(E' R_x), u_m = (u1 + u2)/2.
    default: none; allowed: a number > 0"""
    G: float | str
    """Hamrock-Dowson material number G = alpha E'; 0 for an isoviscous lubricant.
    default: none; allowed: a number >= 0"""
    a_over_R: float | str
    """Hertz radius over R, which M and L leave open and shear stresses depend on. Only with M and L, and [shear] or [friction].
    default: none; allowed: a number > 0 and <= 1"""
    load: float | str
    """Normal load F, of a roller on all of its length. Third language: load, radius_x and the elastic data in SI, with [motion] and eta0.
    default: none; allowed: a number > 0 N"""
    load_per_length: float | str
    """Normal load per length of a line contact, F' = F/length, instead of load. Only with kind = line.
    default: none; allowed: a number > 0 N/m"""
    radius_x: float | str
    """Reduced radius along the entrainment: 1/R_x = 1/R_x1 + 1/R_x2 (ball on flat: the ball's).
    default: none; allowed: a number > 0 m"""
    radius_y: float | str
    """Principal reduced radius across radius_x: 1/R_y = 1/R_y1 + 1/R_y2; or radius_ratio.
    default: radius_x (circular contact); allowed: a number > 0 m"""
    E1: float | str
    """Young's modulus of body 1 (with nu1, E2 and nu2; or E_prime instead of the four).
    default: none; allowed: a number > 0 Pa"""
    nu1: float | str
    """Poisson's ratio of body 1.
    default: none; allowed: a number > -1 and <= 0.5"""
    E2: float | str
    """Young's modulus of body 2.
    default: none; allowed: a number > 0 Pa"""
    nu2: float | str
    """Poisson's ratio of body 2.
    default: none; allowed: a number > -1 and <= 0.5"""
    E_prime: float | str
    """Reduced modulus E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2], instead of E1, nu1, E2, nu2.
    default: none; allowed: a number > 0 Pa"""
    Sq1: float | str
    """Roughness of surface 1, the root mean square of its heights (Sq, or Rq of a profile): for the lambda ratio in the report. The film is computed for smooth surfaces.
    default: none; allowed: a number > 0 and <= 1e-04 m"""
    Sq2: float | str
    """Roughness of surface 2, likewise.
    default: none; allowed: a number > 0 and <= 1e-04 m"""
    radius_ratio: float | str
    """R_x/R_y, the radius along the entrainment over the one across it: below 1 an ellipse that lies across it. With any language; groups, Hertz radii and scales are made with R_x.
    default: 1 (circular contact), or from radius_y; allowed: a number >= 0.005 and <= 200"""
    length: float | str
    """Length of a roller in half widths a of the line contact with its mean load per length. Only with M and L, or W, U and G. (only with [contact] kind = roller)
    default: none; allowed: a number >= 4 and <= 2000"""
    length_m: float | str
    """Length of a roller, all of it that its track may touch. Only with a contact in SI. (only with [contact] kind = roller)
    default: none; allowed: a number > 0 m"""

class MotionKeys(TypedDict, total=False):
    """The speeds of the surfaces: u1 and u2, or u_m and srr. With a contact in M and L or W, U and G srr alone, and only with [shear] or [friction]. And the angle of an ellipse."""
    angle: float | str
    """From the direction of radius_x to that of the entrainment, of an elliptic contact; 90: along radius_y. Not 0 or 90: the whole domain is computed. x stays the direction of entrainment.
    default: 0, along radius_x; allowed: a number >= -90 and <= 90 degrees"""
    u1: float | str
    """Surface speed of body 1 (u1 and u2, or u_m and srr). The oil enters at the side of negative x.
    default: none; allowed: a number >= -1e+06 and <= 1e+06 m/s"""
    u2: float | str
    """Surface speed of body 2.
    default: none; allowed: a number >= -1e+06 and <= 1e+06 m/s"""
    u_m: float | str
    """Entrainment speed (u1 + u2)/2, instead of u1 and u2.
    default: none; allowed: a number > 0 and <= 1e+06 m/s"""
    srr: float | str
    """Slide-roll ratio (u1 - u2)/u_m. A steady, smooth, isothermal Newtonian film does not depend on it; [shear] and [friction] do, with contacts in M and L or W, U and G too.
    default: 0; allowed: a number >= -1e+06 and <= 1e+06"""

class LubricantKeys(TypedDict, total=False):
    """The oil."""
    viscosity: Literal["isoviscous", "barus", "roelands", "doolittle", "yasutomi", "table"]
    """Viscosity law eta/eta0: 1; exp(alpha p); exp{(alpha p0/z)[(1 + p/p0)^z - 1]}; exp{B R0 [1/(v - R0) - 1/(1 - R0)]} with Tait's volume v; 10^{-C1 x/(C2 + x)} eta_g/eta0 with x = (T - Tg) F; or a table.
    default: roelands; allowed: one of isoviscous, barus, roelands, doolittle, yasutomi, table"""
    eta0: float | str
    """Viscosity at ambient pressure; required with loads and speeds in SI and by doolittle. yasutomi, table and kv40 with kv100 bring their own.
    default: none; allowed: a number > 0 and <= 1e+06 Pa s"""
    alpha: float | str
    """Pressure coefficient of the viscosity, Roelands' slope at ambient pressure; or alpha_star. Required for roelands, and for barus in SI; in dimensionless cases it gives the Hertz pressure p_h = alpha_bar/alpha. doolittle, yasutomi and table bring their own, alpha* = 1/int eta0/eta dp.
    default: none; allowed: a number >= 1e-12 and <= 1e-06 1/Pa"""
    z: float | str
    """Roelands' exponent. (only with [lubricant] viscosity = roelands)
    default: alpha p0/(ln eta0 + 9.67) when eta0 is given, else 0.68; with alpha_star what gives it; allowed: a number >= 0.05 and <= 1.5"""
    p0: float | str
    """Roelands' reference pressure. (only with [lubricant] viscosity = roelands)
    default: 1.96e8; allowed: a number >= 1e+06 and <= 1e+10 Pa"""
    density: Literal["incompressible", "dowson-higginson", "tait", "murnaghan", "table"]
    """Density law rho/rho0: 1; (5.9e8 + 1.34 p)/(5.9e8 + p), p in Pa; 1/v, v = 1 - ln[1 + (1 + K0') p/K0]/(1 + K0'); (1 + K0' p/K0)^(1/K0'); or a table.
    default: dowson-higginson; allowed: one of incompressible, dowson-higginson, tait, murnaghan, table"""
    fluid: Literal["mourier", "mineral-vg32", "mineral-vg46", "mineral-vg68", "mineral-vg100", "mineral-vg150", "mineral-vg220", "mineral-vg320", "mineral-vg460", "pao4", "pao6", "pao8", "pao10", "pao40", "squalane"]
    """An oil by name: laws of viscosity and density with their constants, at `temperature` where it has viscosities at two (40 C if none is given). A key that it sets may be repeated with the same value; another value, or a constant of another law, is refused.
    default: none: the keys of [lubricant] say what the oil is; allowed: one of mourier, mineral-vg32, mineral-vg46, mineral-vg68, mineral-vg100, mineral-vg150, mineral-vg220, mineral-vg320, mineral-vg460, pao4, pao6, pao8, pao10, pao40, squalane"""
    temperature: float | str
    """Temperature of oil and bodies. Required with kv40 and kv100, with K00 and beta_K, and by viscosity = yasutomi, above its glass transition Tg0. All other constants hold at the temperature of the contact already.
    default: 40 for a fluid by name that has viscosities at 40 and 100 C; allowed: a number > -273.15 and <= 1000 C"""
    kv40: float | str
    """Kinematic viscosity at 40 C, with kv100, density15 and temperature instead of eta0: viscosity at the temperature by ASTM D341 (Walther).
    default: none; allowed: a number >= 0.21 and <= 1e+05 mm^2/s"""
    kv100: float | str
    """Kinematic viscosity at 100 C, below kv40.
    default: none; allowed: a number >= 0.21 and <= 1e+05 mm^2/s"""
    density15: float | str
    """Density at 15 C; at the temperature with the expansion of lubricating oils, 0.6278/density15 per kelvin.
    default: none; allowed: a number >= 500 and <= 3000 kg/m^3"""
    alpha_star: float | str
    """Pressure coefficient instead of alpha, for barus and roelands: 1/alpha* = int eta0/eta dp. Roelands' z (without eta0: the slope) is found so that the law has it; groups and formulas take it as alpha. alpha is the law's slope at ambient pressure, 5 to 25 % more.
    default: none; allowed: a number >= 1e-12 and <= 1e-06 1/Pa"""
    alpha_temperature: float | str
    """Temperature at which the oil has alpha_star, with kv40 and kv100 and viscosity = roelands: z is the same at every temperature.
    default: temperature; allowed: a number > -273.15 and <= 1000 C"""
    K0: float | str
    """Bulk modulus at ambient pressure, at the temperature of the contact. Required by density = tait and murnaghan and by viscosity = doolittle.
    default: none; allowed: a number >= 1e+07 and <= 1e+12 Pa"""
    K00: float | str
    """With beta_K and temperature instead of K0: K0 = K00 exp(-beta_K T), T in kelvin.
    default: none; allowed: a number >= 1e+08 and <= 1e+14 Pa"""
    beta_K: float | str
    """How the bulk modulus falls with temperature. Required with K00.
    default: none; allowed: a number >= 1e-05 and <= 0.1 1/K"""
    K0_prime: float | str
    """Its derivative with pressure. Required with K0.
    default: none; allowed: a number >= 1 and <= 50"""
    doolittle_B: float | str
    """Doolittle's factor. (only with [lubricant] viscosity = doolittle)
    default: none; allowed: a number > 0 and <= 1000"""
    doolittle_R0: float | str
    """Occupied volume over the volume at ambient pressure, at the temperature of the contact. (only with [lubricant] viscosity = doolittle)
    default: none; allowed: a number > 0 and < 1"""
    Tg0: float | str
    """Glass transition at ambient pressure. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > -273.15 and <= 1000 C"""
    A1: float | str
    """Tg = Tg0 + A1 ln(1 + A2 p). (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 1e+12 K"""
    A2: float | str
    """Tg = Tg0 + A1 ln(1 + A2 p). (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 1e-06 1/Pa"""
    b1: float | str
    """F = (1 + b1 p)^b2. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number >= 0 and <= 1e-06 1/Pa"""
    b2: float | str
    """F = (1 + b1 p)^b2. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number >= -10 and <= 0"""
    C1: float | str
    """First constant of Williams, Landel and Ferry. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 100"""
    C2: float | str
    """Second constant of Williams, Landel and Ferry. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 1000 K"""
    eta_g: float | str
    """Viscosity at the glass transition. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number >= 1000 and <= 1e+15 Pa s"""
    table: str | os.PathLike[str]
    """A CSV file with columns p [Pa], rising from 0, eta [Pa s], rho [kg/m^3], or in the order and units of its heading, as p [MPa], eta [mPa s]; for viscosity = table, density = table or both. At least 4 rows, eta and rho > 0 and rising, up to more than p_h. Beside the deck, or where the program runs.
    default: none; allowed: any text"""

class DomainKeys(TypedDict, total=False):
    """The computed rectangle, in radii of the Hertz contact."""
    x_inlet: float | str
    """Inlet boundary in Hertz radii, beyond the contact. Light loads need a longer inlet.
    default: so far upstream that the film loses less than about 0.6 %; allowed: a number >= -1000 and < 0"""
    x_outlet: float | str
    """Outlet boundary in Hertz radii, beyond the contact.
    default: 1.5, or 3 for light loads; allowed: a number > 0 and <= 1000"""
    y_half: float | str
    """Half width of the domain in Hertz radii, beyond the contact.
    default: half the length of the domain, or a quarter more; allowed: a number > 0 and <= 1e+06"""
    far_field: Literal["closed", "zero"]
    """Pressure on the boundary of the domain and load outside of it: those of nearly rigid bodies in closed form, or none, as in the paper. A load that jumps in time, or changes by more than twice its size in a/u_m, needs zero, and gets it where the deck leaves this open, as an ellipse by half of its load and a body that moves do.
    default: closed; allowed: one of closed, zero"""

class GridKeys(TypedDict, total=False):
    """The finest and the coarsest grid."""
    cells: int
    """Cells of the finest grid along x, the coarsest grid's times a power of two; along y they follow from the domain, as nearly square as possible. Where the contact is seven times as wide as long they are twice as wide, where six times as long as wide 4 or 8 times as long.
    default: 256, 512 or 1024, the first that resolves the film; allowed: a whole number >= 16 and <= 1048576"""
    coarsest: int
    """Cells of the coarsest grid along x.
    default: chosen for the case; allowed: a whole number >= 4 and <= 4096"""
    errors: Literal["adjoint", "levels"]
    """How the errors of Hc and Hm are estimated. adjoint: by what is left of the equations of a coarser grid, times the weights of Hc and Hm for it (upstream3). levels: from the sequence of grids, as of a line contact always; there adjoint makes but the maps of [output] fields.
    default: adjoint; allowed: one of adjoint, levels"""
    accuracy: float | str
    """Relative error of Hc and Hm to reach, instead of cells: the run refines the grid, up to 8192 cells and half of the memory that is free, and extends the domain where x_inlet and y_half are left open, until the estimated error is below it. A domain that is given is kept and its error told, not counted.
    default: none: the grid is given or chosen; allowed: a number >= 1e-06 and <= 0.5"""

class DiscretizationKeys(TypedDict, total=False):
    """How derivatives become differences."""
    wedge: Literal["upstream1", "upstream2", "upstream3", "upstream3_inlet"]
    """The discrete wedge term d(rho H)/dX: first order as in the paper; second order, ten times closer on the same grid; third order where the pressure couples the nodes (epsilon/h^2 above 1) and second elsewhere, five to twenty times closer again with its face; or third order upstream of X = 0 alone.
    default: upstream3; allowed: one of upstream1, upstream2, upstream3, upstream3_inlet"""
    face: Literal["mean", "logmean", "logmean_bounded"]
    """epsilon half-way between two nodes: the mean of the two; or rho H^3/eta of its own, with H from four nodes and the logarithmic mean of 1/eta, several times closer in the rim of the inlet; or that with at least 0.4 of the mean of 1/eta, with which steep pressures behind a spike converge faster.
    default: logmean_bounded with the third-order wedges, mean with the others; allowed: one of mean, logmean, logmean_bounded"""

class DeformationKeys(TypedDict, total=False):
    """How the elastic deformation is evaluated."""
    method: Literal["mlmi", "fft", "direct"]
    """How the elastic deformation is summed: multilevel multi-integration, exact by FFT, or the direct double sum (exact, slow: small grids only).
    default: mlmi; allowed: one of mlmi, fft, direct"""
    order: int
    """Transfer order 2p: 4, 6 or 8. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 4 and <= 8"""
    patch_along: int
    """Radius of the correction patch along the coarsening direction [points]. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 1 and <= 64"""
    patch_across: int
    """Radius of the correction patch across the coarsening direction [points]. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 1 and <= 64"""
    coarsenings: int
    """Number of semi-coarsenings (x and y in turn) before the coarsest sum. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 0 and <= 20"""
    coarsest_sum: Literal["fft", "direct"]
    """How the coarsest grid is summed. (only with [deformation] method = mlmi)
    default: fft; allowed: one of fft, direct"""

class MultigridKeys(TypedDict, total=False):
    """How the full multigrid works; the defaults need no tuning."""
    polish: Literal["rescue", "always", "off"]
    """Newton's method (Newton-Krylov) on the finest grid: where nothing else leads to a solution; always, also after the cycles and down to rounding errors; or never.
    default: rescue; allowed: one of rescue, always, off"""
    cycle: Literal["V", "W", "F"]
    """Shape of the coarse grid correction cycle.
    default: F to the level of the discretization error (V of a line, W of stretched cells), W towards a tolerance; allowed: one of V, W, F"""
    pre: int
    """Relaxations before the coarse grid correction, nu_1.
    default: 2; 3 of contacts long along the motion; 3 or 4 of heavy lines whose viscosity rises steeply at the edge; allowed: a whole number >= 0 and <= 20"""
    post: int
    """Relaxations after the coarse grid correction, nu_2; 0 becomes 1 where the residual asks for it.
    default: 0 to the level of the discretization error (1 of stretched cells), 1 towards a tolerance; 2 or 4 of those with steep viscosity; allowed: a whole number >= 0 and <= 20"""
    cycles: int
    """Cycles on every level of the full multigrid on its way up, at least; the checks ask for more where the level needs them.
    default: 2; allowed: a whole number >= 1 and <= 200"""
    extra_cycles: int
    """Cycles beyond `cycles` on a level below the finest at most, where the checks ask for more; with [supply] four times as many, and on the first level too.
    default: 3; allowed: a whole number >= 0 and <= 200"""
    tolerance: float | str
    """Relative residual of the Reynolds equation to reach on the finest grid (root mean square, over that of the wedge term).
    default: none: until the cycles no longer change Hc and Hm by a tenth of the discretization error; allowed: a number >= 1e-14 and <= 0.1"""
    max_cycles: int
    """Cycles on the finest grid at most, where the checks or the tolerance ask for more than `cycles`.
    default: 60; allowed: a whole number >= 1 and <= 10000"""
    line_solver: Literal["elimination", "decimation"]
    """What solves the line systems of the relaxation: elimination of the band, or the paper's decimation (odd-even reduction). The same solution; the default is the faster.
    default: elimination; allowed: one of elimination, decimation"""
    kernel_terms: int
    """Terms of the elastic influence along a line that its system keeps: 3, 5 or 7.
    default: 3; allowed: a whole number >= 3 and <= 7"""

class ContinuationKeys(TypedDict, total=False):
    """How a high load is reached from lower ones, where that is needed."""
    path: Literal["automatic", "load", "off"]
    """Load continuation, from a lower load to the deck's one: where the full multigrid alone does not lead to a solution; always; or never.
    default: automatic; allowed: one of automatic, load, off"""
    M_start: float | str
    """First load of a continuation, as Moes load number M; L does not depend on the load. (only with [continuation] path = automatic or load)
    default: a hundredth of the contact's M, 20 at least, more where that is not solved; allowed: a number >= 0.1 and <= 1e+05"""
    load_start: float | str
    """The same for a contact in SI, of a line contact in newtons per metre. (only with [continuation] path = automatic or load)
    default: see M_start; allowed: a number > 0 N"""
    step: float | str
    """Factor between the first two loads; later ones follow from the number of cycles. (only with [continuation] path = automatic or load)
    default: 2; allowed: a number > 1 and <= 10"""
    max_steps: int
    """Loads to solve for at most, rejected steps included. (only with [continuation] path = automatic or load)
    default: 60; allowed: a whole number >= 1 and <= 10000"""

class DryKeys(TypedDict, total=False):
    """How a contact without lubricant is solved. Only with [case] kind = dry."""
    tolerance: float | str
    """Largest gap inside the contact and largest overlap outside it, in a^2/R. (only with [case] kind = dry)
    default: 1e-08; allowed: a number >= 1e-12 and <= 0.01"""
    max_iterations: int
    """Iterations on each grid at most. (only with [case] kind = dry)
    default: 500; allowed: a whole number >= 1 and <= 1e+06"""

class TransientKeys(TypedDict, total=False):
    """What happens in time, from the steady contact at time 0."""
    end_time: float | str
    """How long, from the steady state at time 0, in the unit that time_unit says. Without it the contact is steady.
    default: none; allowed: a number > 0"""
    time_unit: Literal["contact", "seconds"]
    """Unit of all times of this section: contact is a/u_m, in which the oil crosses half of the contact; seconds need a contact in SI. (only with [transient] end_time)
    default: contact; allowed: one of contact, seconds"""
    cavitation: Literal["pressure", "content"]
    """Behind the contact, and wherever P = 0: pressure, the gap is taken to be full; content, the oil there is an unknown that moves with the surfaces, and mass is conserved. A full inlet has no other film while it is steady; a load that rises fast presses on what is there. (only with [transient] end_time)
    default: content with a [supply], else pressure; allowed: one of pressure, content"""
    rtol: float | str
    """Relative tolerance of the time integration's error test for pressure and film. (only with [transient] end_time)
    default: 1e-4; allowed: a number >= 1e-07 and <= 0.1"""
    max_step: float | str
    """Longest step of time. (only with [transient] end_time)
    default: from what varies: a quarter of a feature's width at its speed, a quarter of a ramp (of one shorter than 0.04 a/u_m only within it), a twentieth of a period; allowed: a number > 0"""
    max_steps: int
    """Steps after which the run ends as failed. (only with [transient] end_time)
    default: 100000; allowed: a whole number >= 1 and <= 1e+08"""
    output_interval: float | str
    """Time between two fields of P and H in the result. The numbers of every step are always kept. (only with [transient] end_time)
    default: none: the fields of the first and the last time; allowed: a number > 0"""
    load: str | os.PathLike[str]
    """Load over that of [contact], at times: 'time:value ...', linear between them; the same time twice is a jump. Or a file .csv with the columns t and load, where the program runs or beside the deck; a heading may name the unit of t. (only with [transient] end_time)
    default: constant; allowed: any text"""
    load_wave: str | os.PathLike[str]
    """'amplitude period [start]': multiplies the load by 1 + amplitude sin(2 pi (t - start)/period). (only with [transient] end_time)
    default: none; allowed: any text"""
    u1: str | os.PathLike[str]
    """Speed of surface 1 over the entrainment speed u_m of [motion] (of M, L where there is none), written like load. The film is carried by (u1 + u2)/2, which must not be negative. (only with [transient] end_time)
    default: constant: from [motion], else 1; allowed: any text"""
    u1_wave: str | os.PathLike[str]
    """Like load_wave, of u1. (only with [transient] end_time)
    default: none; allowed: any text"""
    u2: str | os.PathLike[str]
    """Speed of surface 2, like u1. (only with [transient] end_time)
    default: constant: from [motion], else 1; allowed: any text"""
    u2_wave: str | os.PathLike[str]
    """Like load_wave, of u2. (only with [transient] end_time)
    default: none; allowed: any text"""
    supply: str | os.PathLike[str]
    """What the surfaces bring, over what [supply] says, written like load; 1 at time 0. Layers of each surface come with its own speed; a flow is a thicker layer where the motion is slower. (only with [transient] end_time)
    default: constant; allowed: any text"""
    supply_wave: str | os.PathLike[str]
    """Like load_wave, of the supply. (only with [transient] end_time)
    default: none; allowed: any text"""
    stop_film: float | str
    """End where the smallest film falls to this, H = hR/a^2. (only with [transient] end_time)
    default: none; allowed: a number > 0"""
    stop_steady: float | str
    """End where Hc, Hm and P_max have changed by less than this, relative, for a time of a/u_m. (only with [transient] end_time)
    default: none; allowed: a number >= 1e-12 and <= 0.1"""

class BodyKeys(TypedDict, total=False):
    """The body's equation of motion in place of an imposed load. Only with [transient]."""
    mass: float | str
    """Mass of the body that moves, in F R/u_m^2: with it H00 follows mass H00'' + damping H00' = load that the film carries - load that acts, both over that of [contact], and the load that acts may be zero. (only with [transient] end_time)
    default: none: the load is imposed; allowed: a number > 0"""
    mass_kg: float | str
    """The same in kg, for a contact in SI. (only with [transient] end_time)
    default: none: the load is imposed; allowed: a number > 0 kg"""
    damping: float | str
    """Damping of the body, in F R/(a u_m). (only with [transient] end_time)
    default: 0; allowed: a number >= 0"""
    damping_Nspm: float | str
    """The same in N s/m, for a contact in SI. (only with [transient] end_time)
    default: 0; allowed: a number >= 0 N s/m"""
    gap: float | str
    """H00 at time 0, in a^2/R: the bodies start apart, without pressure. (only with [transient] end_time)
    default: none: starts from the steady film; allowed: a number > 0"""
    gap_m: float | str
    """The same in m, for a contact in SI. (only with [transient] end_time)
    default: none: starts from the steady film; allowed: a number > 0 m"""
    velocity: float | str
    """H00' at time 0, in a u_m/R; negative: the bodies approach. (only with [transient] end_time)
    default: 0; allowed: a number"""
    velocity_mps: float | str
    """The same in m/s, for a contact in SI. (only with [transient] end_time)
    default: 0; allowed: a number in m/s"""

class Surface1Keys(TypedDict, total=False):
    """What surface 1 carries: through the contact in time, or, in a steady contact, at rest in it."""
    shape: Literal["dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"]
    """What this surface carries, S being what the gap gains, r and d the distances from its middle and its line: dimple height exp(-(r/width)^2), bump the same upwards, groove and ridge likewise with d, waviness height cos(2 pi d/width), in time behind its front at x, cavity height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2); map: measured heights from a file. In time it moves with its surface; in a steady contact it must be on a surface that stands still, in a dry one all do.
    default: none; allowed: one of dimple, bump, ridge, groove, waviness, cavity, map"""
    height: float | str
    """Height (or depth, or amplitude) in units of a^2/R, as H. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    height_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    width: float | str
    """Width, or wavelength, in Hertz radii a. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    width_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    angle: float | str
    """Degrees between the line of a ridge, groove or wave and the y axis: 0 transverse, 90 longitudinal. (only with [surface1] shape = ridge or groove or waviness)
    default: 0; allowed: a number >= -90 and <= 90"""
    x: float | str
    """Where its middle (of waves: a crest of the gap, in time the first) is at time 0, in Hertz radii. (only with [surface1] shape)
    default: in time before the inlet, by three widths, by one wave, by half of a map; steady 0; allowed: a number >= -1000 and <= 1000"""
    y: float | str
    """Where its middle is across the entrainment. (only with [surface1] shape)
    default: 0; allowed: a number >= -1000 and <= 1000"""
    at_rest: Literal["yes"]
    """Says of a steady contact given by M and L, or W, U and G, that it is this surface that stands still and the other one that moves. A contact in SI says it with u1 = 0 or u2 = 0. (only with [surface1] shape)
    default: none; allowed: one of yes"""
    levelling: Literal["plane", "mean"]
    """What is taken away of a map first: the plane of least squares, with the tilt under the instrument; or its mean alone. (only with [surface1] shape = map)
    default: plane; allowed: one of plane, mean"""
    longest_wave: float | str
    """Cut-off wavelength, in Hertz radii, of a Gaussian filter that takes longer waves away. A wave of this length keeps half of its height. Without it all long waves stay. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    longest_wave_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    shortest_wave: float | str
    """The same for shorter waves, which it takes away; without it all short waves stay. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    shortest_wave_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    file: str | os.PathLike[str]
    """The measured heights, counted from the body outwards. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines along x, the first at the smallest y, numbers between semicolons, tabs, commas or blanks, with decimal points or commas; or x, y, z in every line, the points of a regular grid in any order; or Gwyddion's text, ESRI's ASCII grid, SDF of ISO 25178-71 in ASCII. A first line of words is a heading, # begins a comment. Or a .h5 with a dataset in rows of constant y. At least 8 by 8 points; up to a fifth of them may be missing (an empty cell, NaN, BAD, ***) and is filled from its neighbours. It is looked for where the program runs, then beside the deck. It is levelled; onto the mesh it comes as means over the cells. (only with [surface1] shape = map)
    default: none; allowed: any text"""
    dataset: str | os.PathLike[str]
    """The dataset of a .h5. (only with [surface1] shape = map)
    default: height; allowed: any text"""
    unit: float | str
    """Height of the number 1 in the file, in units of a^2/R, as H; unit_m = 1e-9 where the file is in nanometres. May be left out where the file states its unit. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    unit_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    dx: float | str
    """Distance between two points of a line of the file, in Hertz radii. May be left out where the file states it. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    dx_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    dy: float | str
    """Distance between two lines of the file, in Hertz radii. (only with [surface1] shape = map)
    default: that of the file, or of dx; allowed: a number > 0"""
    dy_m: float | str
    """The same in m, for a contact in SI. (only with [surface1] shape = map)
    default: that of the file, or of dx; allowed: a number > 0 m"""
    taper: float | str
    """Share of the map's length along which its heights come down to zero at each of its edges, by a cosine; 0: they end as they are, in a step. (only with [surface1] shape = map)
    default: 0.1; allowed: a number >= 0 and <= 0.5"""

class Surface2Keys(TypedDict, total=False):
    """What surface 2 carries, likewise."""
    shape: Literal["dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"]
    """What this surface carries, S being what the gap gains, r and d the distances from its middle and its line: dimple height exp(-(r/width)^2), bump the same upwards, groove and ridge likewise with d, waviness height cos(2 pi d/width), in time behind its front at x, cavity height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2); map: measured heights from a file. In time it moves with its surface; in a steady contact it must be on a surface that stands still, in a dry one all do.
    default: none; allowed: one of dimple, bump, ridge, groove, waviness, cavity, map"""
    height: float | str
    """Height (or depth, or amplitude) in units of a^2/R, as H. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    height_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    width: float | str
    """Width, or wavelength, in Hertz radii a. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    width_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    angle: float | str
    """Degrees between the line of a ridge, groove or wave and the y axis: 0 transverse, 90 longitudinal. (only with [surface2] shape = ridge or groove or waviness)
    default: 0; allowed: a number >= -90 and <= 90"""
    x: float | str
    """Where its middle (of waves: a crest of the gap, in time the first) is at time 0, in Hertz radii. (only with [surface2] shape)
    default: in time before the inlet, by three widths, by one wave, by half of a map; steady 0; allowed: a number >= -1000 and <= 1000"""
    y: float | str
    """Where its middle is across the entrainment. (only with [surface2] shape)
    default: 0; allowed: a number >= -1000 and <= 1000"""
    at_rest: Literal["yes"]
    """Says of a steady contact given by M and L, or W, U and G, that it is this surface that stands still and the other one that moves. A contact in SI says it with u1 = 0 or u2 = 0. (only with [surface2] shape)
    default: none; allowed: one of yes"""
    levelling: Literal["plane", "mean"]
    """What is taken away of a map first: the plane of least squares, with the tilt under the instrument; or its mean alone. (only with [surface2] shape = map)
    default: plane; allowed: one of plane, mean"""
    longest_wave: float | str
    """Cut-off wavelength, in Hertz radii, of a Gaussian filter that takes longer waves away. A wave of this length keeps half of its height. Without it all long waves stay. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    longest_wave_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    shortest_wave: float | str
    """The same for shorter waves, which it takes away; without it all short waves stay. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    shortest_wave_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    file: str | os.PathLike[str]
    """The measured heights, counted from the body outwards. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines along x, the first at the smallest y, numbers between semicolons, tabs, commas or blanks, with decimal points or commas; or x, y, z in every line, the points of a regular grid in any order; or Gwyddion's text, ESRI's ASCII grid, SDF of ISO 25178-71 in ASCII. A first line of words is a heading, # begins a comment. Or a .h5 with a dataset in rows of constant y. At least 8 by 8 points; up to a fifth of them may be missing (an empty cell, NaN, BAD, ***) and is filled from its neighbours. It is looked for where the program runs, then beside the deck. It is levelled; onto the mesh it comes as means over the cells. (only with [surface2] shape = map)
    default: none; allowed: any text"""
    dataset: str | os.PathLike[str]
    """The dataset of a .h5. (only with [surface2] shape = map)
    default: height; allowed: any text"""
    unit: float | str
    """Height of the number 1 in the file, in units of a^2/R, as H; unit_m = 1e-9 where the file is in nanometres. May be left out where the file states its unit. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    unit_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    dx: float | str
    """Distance between two points of a line of the file, in Hertz radii. May be left out where the file states it. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    dx_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    dy: float | str
    """Distance between two lines of the file, in Hertz radii. (only with [surface2] shape = map)
    default: that of the file, or of dx; allowed: a number > 0"""
    dy_m: float | str
    """The same in m, for a contact in SI. (only with [surface2] shape = map)
    default: that of the file, or of dx; allowed: a number > 0 m"""
    taper: float | str
    """Share of the map's length along which its heights come down to zero at each of its edges, by a cosine; 0: they end as they are, in a step. (only with [surface2] shape = map)
    default: 0.1; allowed: a number >= 0 and <= 0.5"""

class ShearKeys(TypedDict, total=False):
    """Oil that thins where sliding shears it: in the film, and in the friction."""
    law: Literal["eyring", "carreau"]
    """How sliding thins the oil: tau = tau_0 asinh(eta rate/tau_0), or tau = eta rate [1 + (eta rate/G)^2]^((n-1)/2). Without it the oil is Newtonian. Only with surfaces that slide.
    default: none; allowed: one of eyring, carreau"""
    tau_0: float | str
    """Eyring's stress: where thinning begins. (only with [shear] law = eyring)
    default: none; allowed: a number > 0 and <= 1e+15 Pa"""
    G: float | str
    """Carreau's stress: where thinning begins. (only with [shear] law = carreau)
    default: none; allowed: a number > 0 and <= 1e+15 Pa"""
    n: float | str
    """Carreau's exponent: at high rates the stress grows with the rate to the power n. (only with [shear] law = carreau)
    default: none; allowed: a number > 0 and <= 1"""
    flow: Literal["off", "on"] | bool
    """The flow that pressure drives thins the oil as well, with the sliding or without (srr = 0), and meets the viscosity limit/rate where [friction] limit acts: passes behind the solution without it. Off: to first order in that flow, without the limit. (only with [shear] law)
    default: off; allowed: one of off, on"""

class SupplyKeys(TypedDict, total=False):
    """Oil that is missing at the inlet: what the surfaces bring, and a cavitation that conserves mass."""
    H_oil: float | str
    """What both surfaces bring of oil, in units of H: R (u1 h1 + u2 h2)/(u_m a^2). The flooded film and more: hardly starved; a tenth of it: the layer goes through as it is.
    default: none; allowed: a number > 0"""
    layer_m: float | str
    """Layer of oil on both surfaces together, for a contact in SI.
    default: none; allowed: a number > 0 m"""
    layer1_m: float | str
    """Layer on surface 1 alone, brought with its own speed u1 (layer1_m and layer2_m, or layer_m).
    default: none; allowed: a number >= 0 m"""
    layer2_m: float | str
    """Layer on surface 2.
    default: none; allowed: a number >= 0 m"""
    flow_m3_per_s: float | str
    """Oil that is brought to the inlet, spread evenly over the width of the domain.
    default: none; allowed: a number > 0 m^3/s"""
    flow_m2_per_s: float | str
    """Oil that is brought to the inlet of a line contact, per length along y.
    default: none; allowed: a number > 0 m^2/s"""
    profile: str | os.PathLike[str]
    """Layer across the track: a CSV with columns y and h, of both surfaces together, in metres or the units of its heading, y [mm] and h [nm]; of a contact in M and L in units of X and H. It covers the width of the domain.
    default: none; allowed: any text"""
    passes: int
    """Contacts one after another on the same track: what leaves one is brought to the next. The result is the last of them, with a table of all.
    default: 1; allowed: a whole number >= 1 and <= 10000"""
    returning: Literal["both", "surface1", "surface2"]
    """The surfaces that bring to the next pass what they carried away from the last. The other one brings its first layer every time. (only with [supply] passes)
    default: both; allowed: one of both, surface1, surface2"""
    split: float | str
    """Share of the oil that leaves the contact on surface 1. (only with [supply] returning = surface1 or surface2)
    default: equal layers on both surfaces: u1/(u1 + u2); allowed: a number >= 0 and <= 1"""
    pass_time: float | str
    """From one pass to the next, for the levelling and for films against time. (only with [supply] passes)
    default: none; allowed: a number > 0 s"""
    reflow_time: float | str
    """In which the differences of the layer across the track level out to 1/e, towards their mean over the width of the domain. Surface tension is far too slow for that in bearings. (only with [supply] pass_time)
    default: no oil flows back; allowed: a number > 0 s"""

class SubsurfaceKeys(TypedDict, total=False):
    """The stresses below the contact, from the steady pressure."""
    depth: float | str
    """Depth of the lowest plane in Hertz radii: how far below the contact the stresses are computed. Without it they are not.
    default: none; allowed: a number >= 0.01 and <= 1000"""
    planes: int
    """Planes of constant depth, surface and lowest included: number k = 0..n-1 lies at depth (k/(n-1))^1.5, closer to its neighbours near the surface.
    default: 41; allowed: a whole number >= 3 and <= 1000"""
    cells: int
    """The stresses' grid has at most so many cells along x: the contact's grid, halved as often as needed.
    default: 128; allowed: a whole number >= 16 and <= 1048576"""
    poisson: float | str
    """Poisson's ratio of the body whose stresses are computed.
    default: nu1 of [contact], or 0.3; allowed: a number > -1 and <= 0.5"""
    friction: float | str
    """Shear traction on the surface of the body over the pressure, positive along +x: stresses belong to pressure and this traction.
    default: with [friction] the force on surface 1 over the load, as computed; else 0, frictionless; allowed: a number >= -10 and <= 10"""
    fields: Literal["sigma_mises", "tau_max", "sigma_x", "sigma_y", "sigma_z", "tau_xy", "tau_xz", "tau_yz"] | Sequence[Literal["sigma_mises", "tau_max", "sigma_x", "sigma_y", "sigma_z", "tau_xy", "tau_xz", "tau_yz"]]
    """The stresses to keep in space: von Mises' equivalent stress, the largest shear stress, the components. The section at y = 0 has them all.
    default: sigma_mises, tau_max; allowed: any of sigma_mises, tau_max, sigma_x, sigma_y, sigma_z, tau_xy, tau_xz, tau_yz"""

class FrictionKeys(TypedDict, total=False):
    """Friction on both surfaces, from the steady pressure and film."""
    cavitated: Literal["none", "striated", "full"]
    """Computes the friction; and what the cavitated region adds to it: nothing; streamers that carry what left the pressurised film, the rest of the width being gas; or a film that fills the whole gap.
    default: none; allowed: one of none, striated, full"""
    limit: float | str
    """Lambda: the shear stress of sliding stays below the limiting stress Lambda p. Without it there is no limit. It acts on the friction, not on the film.
    default: none; allowed: a number > 0 and <= 10"""
    meniscus: float | str
    """Distance of the inlet meniscus from the middle of the contact in Hertz radii: oil fills the gap as far as the undeformed gap is no wider than there. Friction is counted up to it, outside of the domain too; round a point it grows with the logarithm of this distance. The pressure is that of a flooded contact all the same.
    default: the radius of the bodies along the entrainment; of lines none, the oil goes on for ever; allowed: a number > 1 and <= 1e+06"""
    meniscus_m: float | str
    """The same distance, for a contact in SI.
    default: none; allowed: a number > 0 m"""
    fields: Literal["tau1", "tau2"] | Sequence[Literal["tau1", "tau2"]]
    """Shear stresses to keep as fields: what the film does to surface 1 and to surface 2 along +x.
    default: none; allowed: any of tau1, tau2"""

class ThermalKeys(TypedDict, total=False):
    """Heat in the film and in the bodies, and what it does to the film."""
    T_oil: float | str
    """Temperature of the oil that enters the contact; eta0, alpha and the other constants hold there.
    default: [lubricant] temperature, where that is given; allowed: a number >= -40 and <= 200 C"""
    beta: float | str
    """-d ln(eta)/dT at ambient pressure and T_oil, for barus (exponential) and roelands (S0 of Roelands and Houpert). Or T_second and eta_second, or vogel_B and vogel_C; an oil by kv40 and kv100, doolittle and yasutomi bring their own.
    default: none; allowed: a number >= 1e-04 and <= 0.3 1/K"""
    T_second: float | str
    """Another temperature than T_oil, with eta_second.
    default: none; allowed: a number >= -40 and <= 200 C"""
    eta_second: float | str
    """Viscosity at ambient pressure and T_second.
    default: none; allowed: a number > 0 and <= 1e+06 Pa s"""
    vogel_B: float | str
    """eta = A exp[B/(T - C)].
    default: none; allowed: a number >= 1 and <= 10000 K"""
    vogel_C: float | str
    """The same C, in degrees Celsius: Vogel's pole.
    default: none; allowed: a number >= -273.15 and <= -40 C"""
    volume_expansion: float | str
    """Of viscosity = doolittle: V0 grows by this share per kelvin.
    default: none; allowed: a number >= 1e-05 and <= 0.01 1/K"""
    modulus_decay: float | str
    """Likewise: K0 falls as exp(-this T); [lubricant] beta_K where that is given.
    default: none; allowed: a number >= 1e-05 and <= 0.1 1/K"""
    occupied_expansion: float | str
    """Likewise: R0 grows by this share per kelvin.
    default: none; allowed: a number >= -0.01 and <= 0.01 1/K"""
    k: float | str
    """Conductivity of the oil at ambient pressure.
    default: 0.14; allowed: a number >= 0.01 and <= 10 W/(m K)"""
    c: float | str
    """Heat capacity of the oil at ambient pressure.
    default: 2000; allowed: a number >= 200 and <= 10000 J/(kg K)"""
    rho: float | str
    """Density of the oil at ambient pressure and T_oil: for what it carries of heat.
    default: from density15 where that is given, else 870; allowed: a number >= 500 and <= 3000 kg/m^3"""
    properties: Literal["larsson-andersson", "constant"]
    """k and rho c in the contact: growing with pressure as those of a mineral oil, k 2.1 and rho c 1.3 times as large at 1 GPa; or the same everywhere.
    default: larsson-andersson; allowed: one of larsson-andersson, constant"""
    expansion: float | str
    """Thermal expansion of the oil, -d ln(rho)/dT.
    default: 6.5e-4; allowed: a number >= 0 and <= 0.005 1/K"""
    T_body1: float | str
    """Temperature of body 1 far from the contact.
    default: T_oil; allowed: a number >= -40 and <= 200 C"""
    solid1: Literal["steel", "bk7", "glass", "sapphire", "si3n4", "al2o3", "zro2", "wc"]
    """Material of body 1, for its heat alone; elastic data stand in [contact].
    default: none: k1, c1, rho1; allowed: one of steel, bk7, glass, sapphire, si3n4, al2o3, zro2, wc"""
    k1: float | str
    """Conductivity of body 1, instead of solid1.
    default: none; allowed: a number >= 0.05 and <= 3000 W/(m K)"""
    c1: float | str
    """Its heat capacity.
    default: none; allowed: a number >= 50 and <= 5000 J/(kg K)"""
    rho1: float | str
    """Its density.
    default: none; allowed: a number >= 500 and <= 25000 kg/m^3"""
    T_body2: float | str
    """Temperature of body 2 far from the contact.
    default: T_oil; allowed: a number >= -40 and <= 200 C"""
    solid2: Literal["steel", "bk7", "glass", "sapphire", "si3n4", "al2o3", "zro2", "wc"]
    """Material of body 2, for its heat alone; elastic data stand in [contact].
    default: none: k2, c2, rho2; allowed: one of steel, bk7, glass, sapphire, si3n4, al2o3, zro2, wc"""
    k2: float | str
    """Conductivity of body 2, instead of solid2.
    default: none; allowed: a number >= 0.05 and <= 3000 W/(m K)"""
    c2: float | str
    """Its heat capacity.
    default: none; allowed: a number >= 50 and <= 5000 J/(kg K)"""
    rho2: float | str
    """Its density.
    default: none; allowed: a number >= 500 and <= 25000 kg/m^3"""
    nodes: int
    """Nodes across the film, odd.
    default: 17; allowed: a whole number >= 5 and <= 65"""
    convection: Literal["on", "off"] | bool
    """The oil carries heat.
    default: on; allowed: one of on, off"""
    compression: Literal["on", "off"] | bool
    """Compression heats the oil, and expansion cools it.
    default: on; allowed: one of on, off"""
    solids: Literal["full", "lines"]
    """Bodies as half spaces that move, at any speed; or by Carslaw and Jaeger's lines for fast ones, which are up to 10 % hotter.
    default: full; allowed: one of full, lines"""
    fields: Literal["T_mid", "T_max", "T1", "T2", "section"] | Sequence[Literal["T_mid", "T_max", "T1", "T2", "section"]]
    """Temperatures above T_oil to keep: of the middle of the film, its hottest layer, surface 1 and 2; and the section along x at y = 0 of T(x, z) and u(x, z).
    default: T_mid, T_max, T1, T2; allowed: any of T_mid, T_max, T1, T2, section"""

class RollerKeys(TypedDict, total=False):
    """A roller of finite length: its profile along the axis, and its tilt."""
    profile: Literal["straight", "crowned", "logarithmic", "table"]
    """The shape of the roller along its axis, beside a straight one. straight: with rounded ends, end_length and end_radius. crowned: a circle of crown_radius. logarithmic: by which the dry pressure does not rise at the ends under the design load. table: from a file. The gap ends with the roller; the bodies deform as half-spaces, which at a sharp end they are not. Only with [contact] kind = roller or [case] kind = roller_race, gear_mesh (a tooth's face width).
    default: none; allowed: one of straight, crowned, logarithmic, table"""
    end_length: float | str
    """Length of each rounded end of a straight roller, in half widths a. (only with [roller] profile = straight)
    default: none; allowed: a number > 0"""
    end_length_m: float | str
    """The same in m, for a contact in SI. (only with [roller] profile = straight)
    default: none; allowed: a number > 0 m"""
    end_radius: float | str
    """Radius of these ends over R_x: they fall as the square of the distance over twice the radius, from where the straight part ends. Not smaller than they are long. (only with [roller] profile = straight)
    default: none; allowed: a number > 0"""
    end_radius_m: float | str
    """The same in m, for a contact in SI. (only with [roller] profile = straight)
    default: none; allowed: a number > 0 m"""
    crown_radius: float | str
    """Radius of a crowned roller along its axis, over R_x; half of its length at least. (only with [roller] profile = crowned)
    default: none; allowed: a number > 0"""
    crown_radius_m: float | str
    """The same in m, for a contact in SI. (only with [roller] profile = crowned)
    default: none; allowed: a number > 0 m"""
    design_load: float | str
    """The load that a logarithmic profile was made for, over the load of the contact. (only with [roller] profile = logarithmic)
    default: the load; allowed: a number > 0 and <= 10"""
    design_load_N: float | str
    """The same in N, for a contact in SI. (only with [roller] profile = logarithmic)
    default: the load; allowed: a number > 0 N"""
    shortest_wave: float | str
    """Cut-off wavelength of a traced profile, in half widths a: a Gaussian filter takes shorter waves away. A wave of this length keeps half of its height; the form stays, to its ends. Without it the trace stays as it is. (only with [roller] profile = table)
    default: none; allowed: a number > 0"""
    shortest_wave_m: float | str
    """The same in m, for a contact in SI. (only with [roller] profile = table)
    default: none; allowed: a number > 0 m"""
    levelling: Literal["none", "line"]
    """What is taken away of a traced profile before it is used: none; line: the straight line of least squares, the tilt with which the roller lay below the stylus. (only with [roller] profile = table)
    default: none; allowed: one of none, line"""
    file: str | os.PathLike[str]
    """The profile as a table, y and how far the surface lies below the middle's there, in m; of a contact without units in a and a^2/R. A heading, y [mm] and drop [um], may name other units. At least four rows, y growing, from the middle or from one end to an end, not beyond ten times that; smooth between them. A table from the middle is mirrored. (only with [roller] profile = table)
    default: none; allowed: any text"""
    tilt: float | str
    """Misalignment: what the gap gains along y, dH/dY, a/R of an angle. The side y > 0 stands further off. A tenth of the roller must bear the load, cut into slices. (only with [roller] profile)
    default: 0; allowed: a number >= -100 and <= 100"""
    tilt_mrad: float | str
    """The same in mrad, for a contact in SI. (only with [roller] profile)
    default: none; allowed: a number >= -100 and <= 100 mrad"""

class OutputKeys(TypedDict, total=False):
    """What is kept."""
    file: str | os.PathLike[str]
    """The result file (HDF5); --output overrides it.
    default: name of the deck with .h5; allowed: any text"""
    fields: Literal["P", "H", "rho_bar", "ln_eta_bar", "error_map_Hc", "error_map_Hm"] | Sequence[Literal["P", "H", "rho_bar", "ln_eta_bar", "error_map_Hc", "error_map_Hm"]]
    """The fields to keep: pressure, film, density, logarithm of the viscosity; where the mesh's errors of Hc and Hm are made, with [grid] errors = adjoint and upstream3.
    default: P, H; allowed: any of P, H, rho_bar, ln_eta_bar, error_Hc, error_Hm"""
    checkpoint: float | str
    """Time by the clock between the moments at which a run in time writes its result so far, from which `ehl resume` goes on. (only with [transient] end_time)
    default: 60 in a run in time; allowed: a number > 0 s"""
    probe: str | os.PathLike[str]
    """Points 'X Y, X Y, ...' in Hertz radii at which a run in time keeps P and H at every step, as the columns P_1, H_1, P_2, ... of /transient: of a node where there is one, else by bicubic interpolation, P no less than 0. (only with [transient] end_time)
    default: none; allowed: any text"""

def run(
    deck: Deck,
    *,
    threads: int | None = None,
    progress: Callable[[float, str], bool | None] | None = None,
    case: CaseKeys = ...,
    bearing: BearingKeys = ...,
    gear: GearKeys = ...,
    contact: ContactKeys = ...,
    motion: MotionKeys = ...,
    lubricant: LubricantKeys = ...,
    domain: DomainKeys = ...,
    grid: GridKeys = ...,
    discretization: DiscretizationKeys = ...,
    deformation: DeformationKeys = ...,
    multigrid: MultigridKeys = ...,
    continuation: ContinuationKeys = ...,
    dry: DryKeys = ...,
    transient: TransientKeys = ...,
    body: BodyKeys = ...,
    surface1: Surface1Keys = ...,
    surface2: Surface2Keys = ...,
    shear: ShearKeys = ...,
    supply: SupplyKeys = ...,
    subsurface: SubsurfaceKeys = ...,
    friction: FrictionKeys = ...,
    thermal: ThermalKeys = ...,
    roller: RollerKeys = ...,
    output: OutputKeys = ...,
) -> Result: ...

def check(
    deck: Deck,
    *,
    threads: int | None = None,
    case: CaseKeys = ...,
    bearing: BearingKeys = ...,
    gear: GearKeys = ...,
    contact: ContactKeys = ...,
    motion: MotionKeys = ...,
    lubricant: LubricantKeys = ...,
    domain: DomainKeys = ...,
    grid: GridKeys = ...,
    discretization: DiscretizationKeys = ...,
    deformation: DeformationKeys = ...,
    multigrid: MultigridKeys = ...,
    continuation: ContinuationKeys = ...,
    dry: DryKeys = ...,
    transient: TransientKeys = ...,
    body: BodyKeys = ...,
    surface1: Surface1Keys = ...,
    surface2: Surface2Keys = ...,
    shear: ShearKeys = ...,
    supply: SupplyKeys = ...,
    subsurface: SubsurfaceKeys = ...,
    friction: FrictionKeys = ...,
    thermal: ThermalKeys = ...,
    roller: RollerKeys = ...,
    output: OutputKeys = ...,
) -> Result: ...

def sweep(
    deck: Deck,
    vary: Mapping[str | tuple[str, ...], str | Sequence[Any]] | None = None,
    *,
    cases: pd.DataFrame | str | os.PathLike[str] | None = None,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    keep: bool = False,
    threads: int | None = None,
    quiet: bool = True,
    case: CaseKeys = ...,
    bearing: BearingKeys = ...,
    gear: GearKeys = ...,
    contact: ContactKeys = ...,
    motion: MotionKeys = ...,
    lubricant: LubricantKeys = ...,
    domain: DomainKeys = ...,
    grid: GridKeys = ...,
    discretization: DiscretizationKeys = ...,
    deformation: DeformationKeys = ...,
    multigrid: MultigridKeys = ...,
    continuation: ContinuationKeys = ...,
    dry: DryKeys = ...,
    transient: TransientKeys = ...,
    body: BodyKeys = ...,
    surface1: Surface1Keys = ...,
    surface2: Surface2Keys = ...,
    shear: ShearKeys = ...,
    supply: SupplyKeys = ...,
    subsurface: SubsurfaceKeys = ...,
    friction: FrictionKeys = ...,
    thermal: ThermalKeys = ...,
    roller: RollerKeys = ...,
    output: OutputKeys = ...,
) -> pd.DataFrame: ...
