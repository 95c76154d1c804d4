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
    """Title and kind of the case."""
    title: str | os.PathLike[str]
    """Title of the case, printed on reports and pictures.
    default: untitled; allowed: any text"""
    kind: Literal["lubricated", "dry", "ball_race", "roller_race", "gear_mesh", "cam", "reciprocating", "impact"]
    """Kind of case. lubricated: a lubricated contact. dry: elastic bodies in contact without lubricant, smooth (Hertz) or with the shapes of [surface1] and [surface2]; [contact] then has load, radius_x and the elastic data, or nothing (units of Hertz), and keys of a film are errors. ball_race, roller_race: radii, speeds and load of [contact] and [motion] follow from [bearing]. gear_mesh: they follow from [gear]. cam: they follow from [cam]. In these four, E' and the oil are given as usual. reciprocating: the speeds follow from [stroke]; load and radii are given as usual. impact: a body with the mass and velocity of [impact] meets the film; [contact] then has no load. With [transient] cycle = machine a run in time follows the cam, the pair of teeth or the stroke.
    default: lubricated; allowed: one of lubricated, dry, ball_race, roller_race, gear_mesh, cam, reciprocating, impact"""

class BearingKeys(TypedDict, total=False):
    """A ball or a roller on its race. Used only with [case] kind = ball_race or roller_race."""
    diameter: float | str
    """Diameter D of the ball or roller. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 m"""
    pitch_diameter: float | str
    """Pitch diameter d_m: the diameter of the circle through the centres of the balls or rollers, nearly the mean of bore and outside diameter. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 m"""
    race: Literal["inner", "outer"]
    """Race whose contact is computed. (only with [case] kind = ball_race or roller_race)
    default: inner; allowed: one of inner, outer"""
    conformity: float | str
    """Groove conformity f: radius of the groove over the diameter of the ball. (only with [case] kind = ball_race)
    default: 0.52; allowed: a number > 0.5 and <= 1"""
    contact_angle: float | str
    """Contact angle alpha between the load on the ball and the radial plane, equal at both races. (only with [case] kind = ball_race)
    default: 0; allowed: a number >= 0 and < 90 degrees"""
    length: float | str
    """Length of a cylindrical roller that touches the race. (only with [case] kind = roller_race)
    default: none; allowed: a number > 0 m"""
    load: float | str
    """Load Q on the ball or roller, instead of radial_load. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 N"""
    radial_load: float | str
    """Radial load F_r on the bearing, instead of load. The loads Q of the balls or rollers follow from static equilibrium with rigid rings and no clearance; Q grows with the power 3/2 of the deflection for balls and 10/9 for rollers. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number > 0 N"""
    elements: int
    """Number Z of balls or rollers. (only with [bearing] radial_load)
    default: none; allowed: a whole number >= 3 and <= 1000"""
    azimuth: float | str
    """Angle between the ball or roller and the direction of the radial load. At 0 it carries the largest load. (only with [bearing] radial_load)
    default: 0; allowed: a number >= -180 and <= 180 degrees"""
    rpm_inner: float | str
    """Speed of the inner ring. If one ring speed is given, the other ring stands still; otherwise give two of rpm_inner, rpm_outer and rpm_cage. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number >= -1e+06 and <= 1e+06 1/min"""
    rpm_outer: float | str
    """Speed of the outer ring, positive in the same sense of rotation as the inner ring. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number >= -1e+06 and <= 1e+06 1/min"""
    rpm_cage: float | str
    """Speed of the cage. It follows from the speeds of both rings, or replaces one of them. (only with [case] kind = ball_race or roller_race)
    default: none; allowed: a number >= -1e+06 and <= 1e+06 1/min"""

class GearKeys(TypedDict, total=False):
    """Two spur gears. Used only with [case] kind = gear_mesh."""
    module: float | str
    """Module m of both wheels. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 m"""
    teeth1: int
    """Number of teeth z1 of wheel 1, the driving wheel. Contact begins at the root of its teeth. (only with [case] kind = gear_mesh)
    default: none; allowed: a whole number >= 3 and <= 10000"""
    teeth2: int
    """Number of teeth z2 of wheel 2. (only with [case] kind = gear_mesh)
    default: none; allowed: a whole number >= 3 and <= 10000"""
    pressure_angle: float | str
    """Pressure angle alpha of the basic rack. (only with [case] kind = gear_mesh)
    default: 20; allowed: a number >= 5 and <= 45 degrees"""
    shift1: float | str
    """Profile shift coefficient x1. The tips are shortened so that the tip clearance stays the same. (only with [case] kind = gear_mesh)
    default: 0; allowed: a number >= -2 and <= 2"""
    shift2: float | str
    """Profile shift coefficient x2. (only with [case] kind = gear_mesh)
    default: 0; allowed: a number >= -2 and <= 2"""
    addendum: float | str
    """Addendum over the module, before the change by profile shift. (only with [case] kind = gear_mesh)
    default: 1; allowed: a number > 0 and <= 3"""
    face_width: float | str
    """Face width b over which the teeth touch. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 m"""
    power: float | str
    """Power, instead of torque1. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 W"""
    torque1: float | str
    """Torque on wheel 1, instead of power. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 N m"""
    rpm1: float | str
    """Speed of rotation of wheel 1. (only with [case] kind = gear_mesh)
    default: none; allowed: a number > 0 and <= 1e+06 1/min"""
    position: float | str
    """Point of contact on the path of contact. 0: contact begins, at the tip of wheel 2. 1: contact ends, at the tip of wheel 1. In time, the state whose scales the results have; the course is the whole path. (only with [case] kind = gear_mesh)
    default: the pitch point, if it lies on the path of contact; allowed: a number >= 0 and <= 1"""
    sharing: Literal["none", "linear"]
    """How two pairs of teeth share the load. linear: equal stiffness and no tip relief: the share rises from 1/3 at the beginning of contact to 2/3, is 1 while one pair is alone, and falls from 2/3 to 1/3 at the end; for a contact ratio below 2. none: every pair carries the whole load. (only with [case] kind = gear_mesh)
    default: linear; allowed: one of none, linear"""
    transition: float | str
    """Part of the path on which the load changes, in a course in time, where the next pair of teeth begins to carry and where the last one ceases to: 2/3 to 1 and 1 to 2/3 of the load. (only with [transient] cycle = machine)
    default: 0.01; allowed: a number >= 1e-04 and <= 0.1"""
    states: int
    """Number of states along the path, between which a course in time is linear. (only with [transient] cycle = machine)
    default: 100; allowed: a whole number >= 12 and <= 3600"""

class CamKeys(TypedDict, total=False):
    """A cam and a flat tappet. Used only with [case] kind = cam."""
    base_radius: float | str
    """Radius of the base circle, on which the lift is 0. (only with [case] kind = cam)
    default: none; allowed: a number > 0 m"""
    lift: str | os.PathLike[str]
    """Text file with the columns angle [degrees] and lift [m], with other units if the heading names them: one revolution, whose last row repeats the first; or the part of it in which the tappet moves, with lift 0 at both ends. A third column load [N] replaces the spring. A cubic spline gives the curvature of the cam, so the lift needs enough digits: the report estimates the error. (only with [case] kind = cam)
    default: none; allowed: any text"""
    face_width: float | str
    """Width over which cam and tappet touch. (only with [case] kind = cam)
    default: none; allowed: a number > 0 m"""
    rpm: float | str
    """Speed of the camshaft. The angle of the table rises with time. (only with [case] kind = cam)
    default: none; allowed: a number > 0 and <= 1e+06 1/min"""
    spring_force: float | str
    """Force of the spring where the lift is 0. (only with [case] kind = cam)
    default: 0; allowed: a number >= 0 N"""
    spring_stiffness: float | str
    """Stiffness of the spring: the load is spring_force + spring_stiffness lift + mass (acceleration of the lift). (only with [case] kind = cam)
    default: 0; allowed: a number >= 0 N/m"""
    mass: float | str
    """Mass that moves with the tappet. (only with [case] kind = cam)
    default: 0; allowed: a number >= 0 kg"""
    angle: float | str
    """Angle of the cam whose contact is computed; in time, the state whose scales the results have and at which the course begins. The mean speed must be positive there. (only with [case] kind = cam)
    default: the first of the table; allowed: a number >= -360 and <= 720 degrees"""
    states: int
    """Number of states in one revolution, between which a course in time is linear. (only with [transient] cycle = machine)
    default: 180; allowed: a whole number >= 12 and <= 3600"""

class StrokeKeys(TypedDict, total=False):
    """A body that moves to and fro. Used only with [case] kind = reciprocating."""
    length: float | str
    """Stroke of body 1 between its turning points, twice the amplitude of its sine. (only with [case] kind = reciprocating)
    default: none; allowed: a number > 0 m"""
    frequency: float | str
    """Number of double strokes in a second. (only with [case] kind = reciprocating)
    default: none; allowed: a number > 0 and <= 1e+06 1/s"""
    second_body: Literal["rests", "rolls"]
    """rests: body 2 stands still in the contact, which slides (a clamped ball on a moving plate). rolls: body 2 turns freely about a fixed axis, with the speed of body 1. (only with [case] kind = reciprocating)
    default: rests; allowed: one of rests, rolls"""
    states: int
    """Number of states in one double stroke, between which a course in time is linear. (only with [transient] cycle = machine)
    default: 100; allowed: a whole number >= 12 and <= 3600"""

class ImpactKeys(TypedDict, total=False):
    """A body that falls on a film. Used only with [case] kind = impact."""
    mass: float | str
    """Mass of the body that meets a body at rest; of two free bodies m1 m2/(m1 + m2). (only with [case] kind = impact)
    default: none; allowed: a number > 0 kg"""
    velocity: float | str
    """Velocity with which the bodies approach at time 0. (only with [case] kind = impact)
    default: none; allowed: a number > 0 and <= 1000 m/s"""
    gap: float | str
    """Distance of the bodies at time 0, filled with oil. (only with [case] kind = impact)
    default: none; allowed: a number > 0 m"""

class ContactKeys(TypedDict, total=False):
    """The contact, given in one of three ways: M and L (Moes); W, U and G (Hamrock and Dowson); or SI: load, radius_x and the elastic data."""
    kind: Literal["point", "line", "roller"]
    """Kind of contact. point: a circle or an ellipse. line: long bodies, straight across the motion, such as gear teeth and cams; nothing varies along y, and forces are per length: M = W (2U)^(-1/2) with W = F'/(E' R_x) and F' the load per length. roller: a line contact of the given length, with the profile of [roller]; M and W are those of its mean load per length.
    default: point; allowed: one of point, line, roller"""
    M: float | str
    """Moes load number M = W (2U)^(-3/4). M and L are the first of three ways to give the contact.
    default: none; allowed: a number >= 0.1 and <= 1e+05"""
    L: float | str
    """Moes material number L = G (2U)^(1/4); 0 for an isoviscous lubricant.
    default: none; allowed: a number >= 0 and <= 100"""
    W: float | str
    """Hamrock-Dowson load number W = F/(E' R_x^2). W, U and G are the second way to give the contact.
    default: none; allowed: a number > 0"""
    U: float | str
    """Hamrock-Dowson speed number U = eta0 u_m/(E' R_x), u_m = (u1 + u2)/2.
    default: none; allowed: a number > 0"""
    G: float | str
    """Hamrock-Dowson material number G = alpha E'; 0 for an isoviscous lubricant.
    default: none; allowed: a number >= 0"""
    a_over_R: float | str
    """Hertz radius over R_x, a/R. M and L leave it open, and shear stresses depend on it. Used only with M and L, and with [shear] or [friction].
    default: none; allowed: a number > 0 and <= 1"""
    load: float | str
    """Normal load F; for a roller, the load on its whole length. load, radius_x and the elastic data in SI, with [motion] and eta0, are the third way to give the contact.
    default: none; allowed: a number > 0 N"""
    load_per_length: float | str
    """Normal load per length of a line contact, F' = F/length, instead of load. Used only with kind = line.
    default: none; allowed: a number > 0 N/m"""
    radius_x: float | str
    """Reduced radius in the rolling direction: 1/R_x = 1/R_x1 + 1/R_x2. For a ball on a flat it is the radius of the ball.
    default: none; allowed: a number > 0 m"""
    radius_y: float | str
    """Reduced radius at right angles to radius_x: 1/R_y = 1/R_y1 + 1/R_y2. radius_ratio may be given instead.
    default: radius_x (circular contact); allowed: a number > 0 m"""
    E1: float | str
    """Young's modulus of body 1. Give E1, nu1, E2 and nu2 together, or E_prime instead.
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
    """Reduced modulus E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2], instead of E1, nu1, E2 and nu2.
    default: none; allowed: a number > 0 Pa"""
    Sq1: float | str
    """Root mean square height of surface 1 (Sq of a map, Rq of a profile), for the lambda ratio in the report. The film is computed for smooth surfaces.
    default: none; allowed: a number > 0 and <= 1e-04 m"""
    Sq2: float | str
    """Root mean square height of surface 2, see Sq1.
    default: none; allowed: a number > 0 and <= 1e-04 m"""
    coating1_E: float | str
    """Young's modulus of an elastic coating bonded to body 1. Give it with its nu and thickness, and E1, nu1, E2 and nu2 of the bodies below. The scales E', a, p_h, M and L are then those of uncoated bodies that yield about as much.
    default: none; allowed: a number > 0 Pa"""
    coating1_nu: float | str
    """Poisson's ratio of the coating of body 1.
    default: none; allowed: a number > -1 and <= 0.5"""
    coating1_thickness: float | str
    """Thickness of the coating of body 1.
    default: none; allowed: a number > 0 and <= 1 m"""
    coating2_E: float | str
    """Young's modulus of an elastic coating bonded to body 2. Give it with its nu and thickness, and E1, nu1, E2 and nu2 of the bodies below. The scales E', a, p_h, M and L are then those of uncoated bodies that yield about as much.
    default: none; allowed: a number > 0 Pa"""
    coating2_nu: float | str
    """Poisson's ratio of the coating of body 2.
    default: none; allowed: a number > -1 and <= 0.5"""
    coating2_thickness: float | str
    """Thickness of the coating of body 2.
    default: none; allowed: a number > 0 and <= 1 m"""
    radius_ratio: float | str
    """R_x/R_y, the reduced radius in the rolling direction over the one across it. Below 1 the contact is an ellipse that is wider than long. It may be given with each of the three ways; groups, Hertz radii and scales are defined with R_x.
    default: 1 (circular contact), or from radius_y; allowed: a number >= 0.005 and <= 200"""
    length: float | str
    """Length of the roller in half widths a of the line contact with its mean load per length. Used only with M and L, or with W, U and G. (only with [contact] kind = roller)
    default: none; allowed: a number >= 4 and <= 2000"""
    length_m: float | str
    """Length of the roller: its total length available for contact. Used only with a contact in SI. (only with [contact] kind = roller)
    default: none; allowed: a number > 0 m"""

class MotionKeys(TypedDict, total=False):
    """Speeds of the surfaces: u1 and u2, or u_m and srr. For a contact in M and L or in W, U and G only srr is given, and only with [shear] or [friction]. Also the rolling direction of an ellipse."""
    angle: float | str
    """Angle from the direction of radius_x to the rolling direction, for an elliptic contact; 90: rolling along radius_y. For other angles than 0 and 90 the contact is oblique and the whole domain is computed. x is always the rolling direction.
    default: 0: along radius_x; allowed: a number >= -90 and <= 90 degrees"""
    u1: float | str
    """Surface speed of body 1. Give u1 and u2, or u_m and srr. The oil enters at negative x.
    default: none; allowed: a number >= -1e+06 and <= 1e+06 m/s"""
    u2: float | str
    """Surface speed of body 2.
    default: none; allowed: a number >= -1e+06 and <= 1e+06 m/s"""
    u_m: float | str
    """Entrainment speed (u1 + u2)/2, instead of u1 and u2.
    default: none; allowed: a number > 0 and <= 1e+06 m/s"""
    srr: float | str
    """Slide-roll ratio (u1 - u2)/u_m. The film of a steady, smooth, isothermal, Newtonian contact does not depend on it. [shear] and [friction] use it, also when the contact is given by M and L or by W, U and G.
    default: 0; allowed: a number >= -1e+06 and <= 1e+06"""

class LubricantKeys(TypedDict, total=False):
    """The lubricant: viscosity and density against pressure."""
    viscosity: Literal["isoviscous", "barus", "roelands", "doolittle", "yasutomi", "table"]
    """Viscosity law eta/eta0. isoviscous: 1. barus: exp(alpha p). roelands: exp{(alpha p0/z)[(1 + p/p0)^z - 1]}. doolittle: exp{B R0 [1/(v - R0) - 1/(1 - R0)]} with Tait's volume v. yasutomi: 10^{-C1 x/(C2 + x)} eta_g/eta0 with x = (T - Tg) F. table: from a file.
    default: roelands; allowed: one of isoviscous, barus, roelands, doolittle, yasutomi, table"""
    eta0: float | str
    """Viscosity at ambient pressure. Required for a contact in SI and with viscosity = doolittle. It follows from yasutomi, from table, and from kv40 and kv100.
    default: none; allowed: a number > 0 and <= 1e+06 Pa s"""
    alpha: float | str
    """Pressure coefficient of the viscosity: the slope of ln eta at ambient pressure; or give alpha_star. Required for roelands, and for barus in SI. In a dimensionless contact it determines the Hertz pressure, p_h = alpha_bar/alpha. doolittle, yasutomi and table have their own alpha*, 1/alpha* = int eta0/eta dp.
    default: none; allowed: a number >= 1e-12 and <= 1e-06 1/Pa"""
    z: float | str
    """Exponent z of Roelands' law. (only with [lubricant] viscosity = roelands)
    default: alpha p0/(ln eta0 + 9.67) if eta0 is given, else 0.68; with alpha_star: chosen so that alpha* is met; allowed: a number >= 0.05 and <= 1.5"""
    p0: float | str
    """Reference pressure p0 of Roelands' law. (only with [lubricant] viscosity = roelands)
    default: 1.96e8; allowed: a number >= 1e+06 and <= 1e+10 Pa"""
    density: Literal["incompressible", "dowson-higginson", "tait", "murnaghan", "table"]
    """Density law rho/rho0. incompressible: 1. dowson-higginson: (5.9e8 + 1.34 p)/(5.9e8 + p), p in Pa. tait: 1/v, v = 1 - ln[1 + (1 + K0') p/K0]/(1 + K0'). murnaghan: (1 + K0' p/K0)^(1/K0'). table: from a file.
    default: dowson-higginson; allowed: one of incompressible, dowson-higginson, tait, murnaghan, table"""
    fluid: Literal["mourier", "mineral-vg32", "mineral-vg46", "mineral-vg68", "mineral-vg100", "mineral-vg150", "mineral-vg220", "mineral-vg320", "mineral-vg460", "pao4", "pao6", "pao8", "pao10", "pao40", "squalane"]
    """Oil by name: laws of viscosity and density with their constants. If its viscosities at two temperatures are known, `temperature` applies (default 40 C). A key that the oil sets may be repeated with the same value; another value, or a constant of another law, is an error.
    default: none: the oil is given by the keys of [lubricant]; allowed: one of mourier, mineral-vg32, mineral-vg46, mineral-vg68, mineral-vg100, mineral-vg150, mineral-vg220, mineral-vg320, mineral-vg460, pao4, pao6, pao8, pao10, pao40, squalane"""
    temperature: float | str
    """Temperature of oil and bodies. It is required with kv40 and kv100, with K00 and beta_K, and with viscosity = yasutomi, where it must lie above the glass transition Tg0. All other constants are values at the temperature of the contact.
    default: 40 for an oil by name whose viscosities at 40 and 100 C are known; allowed: a number > -273.15 and <= 1000 C"""
    kv40: float | str
    """Kinematic viscosity at 40 C. kv40, kv100, density15 and temperature replace eta0: the viscosity at the temperature follows from ASTM D341 (Walther).
    default: none; allowed: a number >= 0.21 and <= 1e+05 mm^2/s"""
    kv100: float | str
    """Kinematic viscosity at 100 C. It must be below kv40.
    default: none; allowed: a number >= 0.21 and <= 1e+05 mm^2/s"""
    density15: float | str
    """Density at 15 C. The density at the temperature follows with the thermal expansion of lubricating oils, 0.6278/density15 per kelvin.
    default: none; allowed: a number >= 500 and <= 3000 kg/m^3"""
    alpha_star: float | str
    """Pressure coefficient alpha*, defined by 1/alpha* = int eta0/eta dp, instead of alpha, for viscosity = barus and roelands. Roelands' z (without eta0: the slope) is chosen so that alpha* is met. Groups and film formulas use alpha* as alpha. alpha is the slope of the law at ambient pressure, 5 to 25 % larger.
    default: none; allowed: a number >= 1e-12 and <= 1e-06 1/Pa"""
    alpha_temperature: float | str
    """Temperature at which the oil has alpha_star, with kv40, kv100 and viscosity = roelands. z is the same at every temperature.
    default: temperature; allowed: a number > -273.15 and <= 1000 C"""
    K0: float | str
    """Bulk modulus at ambient pressure and at the temperature of the contact. Required for density = tait and murnaghan and for viscosity = doolittle.
    default: none; allowed: a number >= 1e+07 and <= 1e+12 Pa"""
    K00: float | str
    """Factor of the bulk modulus against temperature: K0 = K00 exp(-beta_K T), T in kelvin. K00, beta_K and temperature replace K0.
    default: none; allowed: a number >= 1e+08 and <= 1e+14 Pa"""
    beta_K: float | str
    """Decay of the bulk modulus with temperature, see K00. Required with K00.
    default: none; allowed: a number >= 1e-05 and <= 0.1 1/K"""
    K0_prime: float | str
    """Derivative K0' of the bulk modulus with respect to pressure. Required with K0.
    default: none; allowed: a number >= 1 and <= 50"""
    doolittle_B: float | str
    """Doolittle's factor B. (only with [lubricant] viscosity = doolittle)
    default: none; allowed: a number > 0 and <= 1000"""
    doolittle_R0: float | str
    """Occupied volume R0 over the volume at ambient pressure, at the temperature of the contact. (only with [lubricant] viscosity = doolittle)
    default: none; allowed: a number > 0 and < 1"""
    Tg0: float | str
    """Glass transition temperature at ambient pressure, Tg = Tg0 + A1 ln(1 + A2 p). (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > -273.15 and <= 1000 C"""
    A1: float | str
    """Constant of the glass transition, Tg = Tg0 + A1 ln(1 + A2 p). (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 1e+12 K"""
    A2: float | str
    """Constant of the glass transition, Tg = Tg0 + A1 ln(1 + A2 p). (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 1e-06 1/Pa"""
    b1: float | str
    """Constant of F = (1 + b1 p)^b2. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number >= 0 and <= 1e-06 1/Pa"""
    b2: float | str
    """Constant of F = (1 + b1 p)^b2. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number >= -10 and <= 0"""
    C1: float | str
    """First constant of the equation of Williams, Landel and Ferry. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 100"""
    C2: float | str
    """Second constant of the equation of Williams, Landel and Ferry. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number > 0 and <= 1000 K"""
    eta_g: float | str
    """Viscosity at the glass transition. (only with [lubricant] viscosity = yasutomi)
    default: none; allowed: a number >= 1000 and <= 1e+15 Pa s"""
    table: str | os.PathLike[str]
    """CSV file with the columns p [Pa], rising from 0, eta [Pa s] and rho [kg/m^3]; a heading may give another order and other units, such as p [MPa], eta [mPa s]. For viscosity = table, density = table, or both. It needs at least 4 rows with eta and rho > 0 and rising, up to more than p_h. The file is searched beside the deck and in the working folder.
    default: none; allowed: any text"""

class DomainKeys(TypedDict, total=False):
    """Domain of the computation: a rectangle, in Hertz radii."""
    x_inlet: float | str
    """Position of the inlet boundary in Hertz radii. It must lie outside the contact. Light loads need a longer inlet.
    default: chosen so that the end of the domain changes the film by less than about 0.6 %, with far_field = closed far less; allowed: a number >= -1000 and < 0"""
    x_outlet: float | str
    """Position of the outlet boundary in Hertz radii. It must lie outside the contact.
    default: 1.5 half lengths of the contact; 3 or more for light loads; allowed: a number > 0 and <= 1000"""
    y_half: float | str
    """Half width of the domain in Hertz radii. The sides must lie outside the contact.
    default: circle: half the length of the domain, or 1.25 times that with far_field = closed; ellipse: to where the gap is as wide as at the inlet; roller: half of its length; allowed: a number > 0 and <= 1e+06"""
    far_field: Literal["closed", "zero"]
    """Pressure on the boundary of the domain, and load outside of it. closed: those of nearly rigid bodies, in closed form. zero: none, as in the paper. A load that jumps in time, or changes by more than twice its size within a/u_m, requires zero; so do rollers, line contacts in time, and a conserved oil content ([supply]). If the key is left out, zero is taken there, for [body], and for an ellipse whose load changes by more than half of its size within a/u_m.
    default: closed; allowed: one of closed, zero"""

class GridKeys(TypedDict, total=False):
    """Finest and coarsest grid, and the required accuracy."""
    cells: int
    """Number of cells along x of the finest grid: that of the coarsest grid times a power of two. The number along y follows from the domain so that the cells are nearly square. If the contact is more than 7 times as wide (y) as long (x), the cells are twice as wide as long; if it is at least 6 times as long as wide and not oblique, they are 4, 8 or 16 times as long as wide.
    default: the first of 256, 512 and 1024 that resolves the film; line contacts and ellipses may get more; allowed: a whole number >= 16 and <= 1048576"""
    coarsest: int
    """Number of cells along x of the coarsest grid.
    default: chosen for the case; allowed: a whole number >= 4 and <= 4096"""
    errors: Literal["adjoint", "levels"]
    """How the discretization errors of Hc and Hm are estimated. adjoint: truncation error of a coarser grid, weighted by the adjoint solutions of Hc and Hm; only with wedge = upstream3 and without [supply]. levels: from the results of the sequence of grids. Line contacts always use levels; for them, adjoint adds only the maps error_Hc and error_Hm of [output] fields.
    default: adjoint; allowed: one of adjoint, levels"""
    accuracy: float | str
    """Relative error of Hc and Hm to reach, instead of cells. The run refines the grid until the estimated error is below this value, up to 8192 cells and half of the free memory. With far_field = zero it also extends the domain, unless x_inlet or y_half is given; the error of a given domain is reported, but not counted.
    default: none: the grid is given or chosen; allowed: a number >= 1e-06 and <= 0.5"""

class DiscretizationKeys(TypedDict, total=False):
    """Discretization of the Reynolds equation."""
    wedge: Literal["upstream1", "upstream2", "upstream3", "upstream3_inlet"]
    """Discretization of the wedge term d(rho H)/dX. upstream1: first order, as in the paper. upstream2: second order. upstream3: third order where the pressure couples the nodes (epsilon/h^2 above 1), second order elsewhere. upstream3_inlet: third order upstream of X = 0, second order downstream.
    default: upstream3; allowed: one of upstream1, upstream2, upstream3, upstream3_inlet"""
    face: Literal["mean", "logmean", "logmean_bounded"]
    """Value of epsilon half-way between two nodes. mean: mean of the two nodes. logmean: rho H^3/eta of the half point, with H from four nodes and the logarithmic mean of 1/eta; more accurate at the edge of the contact in the inlet. logmean_bounded: as logmean, but at least 0.4 of the mean of 1/eta; it converges faster at steep pressures behind a spike.
    default: logmean_bounded with the third-order wedge terms, mean with the others; allowed: one of mean, logmean, logmean_bounded"""

class DeformationKeys(TypedDict, total=False):
    """Evaluation of the elastic deformation."""
    method: Literal["mlmi", "fft", "direct"]
    """How the elastic deformation is computed. mlmi: multilevel multi-integration. fft: fast Fourier transform, exact. direct: double sum, exact and slow, for small grids only.
    default: mlmi; allowed: one of mlmi, fft, direct"""
    order: int
    """Order 2p of the transfers between grids: 4, 6 or 8. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: an even number >= 4 and <= 8"""
    patch_along: int
    """Radius of the correction patch in the coarsening direction, in points. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 1 and <= 64"""
    patch_across: int
    """Radius of the correction patch at right angles to the coarsening direction, in points. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 1 and <= 64"""
    coarsenings: int
    """Number of semi-coarsenings, in x and y by turns, before the sum on the coarsest grid. (only with [deformation] method = mlmi)
    default: chosen for the grid; allowed: a whole number >= 0 and <= 20"""
    coarsest_sum: Literal["fft", "direct"]
    """How the sum on the coarsest grid is computed. (only with [deformation] method = mlmi)
    default: fft; allowed: one of fft, direct"""

class MultigridKeys(TypedDict, total=False):
    """Parameters of the full multigrid solution. The defaults need no tuning."""
    polish: Literal["rescue", "always", "off"]
    """Newton refinement (Newton-Krylov) on the finest grid. rescue: only if no other strategy finds a solution. always: also after the cycles, down to rounding errors. off: never.
    default: rescue; allowed: one of rescue, always, off"""
    cycle: Literal["V", "W", "F"]
    """Shape of the multigrid cycle. F becomes W above the first grid if the residual falls too slowly.
    default: F if the discretization error decides (V for a line contact), W with a tolerance or on stretched cells; allowed: one of V, W, F"""
    pre: int
    """Number of relaxations before the coarse grid correction, nu_1.
    default: 2; 3 for contacts elongated in the rolling direction; 3 or 4 for heavily loaded line contacts whose viscosity rises steeply at the edge of the contact; allowed: a whole number >= 0 and <= 20"""
    post: int
    """Number of relaxations after the coarse grid correction, nu_2. A value of 0 becomes 1 if the residual falls too slowly.
    default: 0 if the discretization error decides; 1 with a tolerance, on stretched cells, or where the viscosity rises steeply at the edge of the contact; with such viscosity 2 for elongated contacts and 2 or 4 for line contacts; allowed: a whole number >= 0 and <= 20"""
    cycles: int
    """Smallest number of cycles on every level of full multigrid. The convergence checks add cycles where a level needs them.
    default: 2; allowed: a whole number >= 1 and <= 200"""
    extra_cycles: int
    """Largest number of cycles in addition to `cycles` on a level below the finest, if the convergence checks ask for them. [supply] allows four times as many, on the first level too.
    default: 3; allowed: a whole number >= 0 and <= 200"""
    tolerance: float | str
    """Relative residual of the Reynolds equation to reach on the finest grid: its root mean square over that of the wedge term.
    default: none: the cycles end when they change Hc and Hm by less than a tenth of the discretization error; allowed: a number >= 1e-14 and <= 0.1"""
    max_cycles: int
    """Largest number of cycles on the finest grid, if the convergence checks or the tolerance ask for more than `cycles`.
    default: 60; allowed: a whole number >= 1 and <= 10000"""
    line_solver: Literal["elimination", "decimation"]
    """Solver of the line systems of the relaxation. elimination: Gaussian elimination of the band, the faster one. decimation: odd-even reduction, as in the paper. Both give the same solution.
    default: elimination; allowed: one of elimination, decimation"""
    kernel_terms: int
    """Number of terms of the elastic influence along a line that the line system keeps: 3, 5 or 7.
    default: 3; allowed: an odd number >= 3 and <= 7"""

class ContinuationKeys(TypedDict, total=False):
    """Load continuation: a high load is reached from lower ones if needed."""
    path: Literal["automatic", "load", "off"]
    """Load continuation from a lower load up to that of the deck. automatic: only if full multigrid alone does not find a solution. load: always. off: never.
    default: automatic; allowed: one of automatic, load, off"""
    M_start: float | str
    """First load of the continuation, as Moes load number M. L does not depend on the load. (only with [continuation] path = automatic or load)
    default: a hundredth of the contact's M, but at least 20; a higher load if that one is not solved; allowed: a number >= 0.1 and <= 1e+05"""
    load_start: float | str
    """First load of the continuation, for a contact in SI. For a line contact: in newtons per metre. (only with [continuation] path = automatic or load)
    default: see M_start; allowed: a number > 0 N"""
    step: float | str
    """Ratio of the second load to the first one. Later ratios follow from the number of cycles that the solutions take. (only with [continuation] path = automatic or load)
    default: 2; allowed: a number > 1 and <= 10"""
    max_steps: int
    """Largest number of loads to solve for, rejected steps included. (only with [continuation] path = automatic or load)
    default: 60; allowed: a whole number >= 1 and <= 10000"""

class DryKeys(TypedDict, total=False):
    """Solution of a contact without lubricant. Used only with [case] kind = dry."""
    tolerance: float | str
    """Accuracy of the dry contact: largest gap inside the contact and largest overlap outside it, in a^2/R. (only with [case] kind = dry)
    default: 1e-08; allowed: a number >= 1e-12 and <= 0.01"""
    max_iterations: int
    """Largest number of iterations on each grid. (only with [case] kind = dry)
    default: 500; allowed: a whole number >= 1 and <= 1e+06"""

class TransientKeys(TypedDict, total=False):
    """Time-dependent contact, from the steady solution at time 0."""
    end_time: float | str
    """Time at which the run ends, in units of time_unit. The run starts from the steady solution at time 0. Without this key the contact is steady.
    default: none; allowed: a number > 0"""
    time_unit: Literal["contact", "seconds"]
    """Unit of all times of this section. contact: a/u_m, the time in which the oil crosses half of the contact. seconds: needs a contact in SI. (only with [transient] end_time)
    default: contact; allowed: one of contact, seconds"""
    cavitation: Literal["pressure", "content"]
    """Model of the region with P = 0. pressure: the gap is taken as full of oil. content: the oil content of the gap is an unknown that moves with the surfaces, and mass is conserved. A steady contact with a flooded inlet has the same film with both; they differ when a rapidly rising load pressurizes the cavitated region. (only with [transient] end_time)
    default: content with [supply], else pressure; allowed: one of pressure, content"""
    rtol: float | str
    """Relative tolerance of pressure and film in the error test of the time integration. (only with [transient] end_time)
    default: 1e-4; allowed: a number >= 1e-07 and <= 0.1"""
    max_step: float | str
    """Largest time step. (only with [transient] end_time)
    default: follows from what varies: a quarter of the time in which a feature passes, a quarter of a ramp (one shorter than 0.04 a/u_m counts only while it lasts), a twentieth of a period; allowed: a number > 0"""
    max_steps: int
    """Largest number of time steps. A run that needs more fails. (only with [transient] end_time)
    default: 100000; allowed: a whole number >= 1 and <= 1e+08"""
    output_interval: float | str
    """Time between two stored fields of P and H. The values of every step are always stored. (only with [transient] end_time)
    default: none: the fields of the first and the last time only; allowed: a number > 0"""
    start_of_means: float | str
    """Time from which on extremes and means of a run are taken, for the report and the rows of a sweep. Without it the last whole period of a cycle counts, else the whole run. (only with [transient] end_time)
    default: the start of the last whole period of a cycle, else 0; allowed: a number >= 0"""
    error: Literal["on", "off"] | bool
    """on: error bars of Hc, Hm, P_max and mu at every step, and of their extremes and means, from two more runs: one on half the cells, and one that also has ten times the tolerance. They cover mesh and time steps, and not the size of the domain. (only with [transient] end_time)
    default: off; allowed: one of on, off"""
    load: str | os.PathLike[str]
    """Load over that of [contact] against time: 'time:value ...', linear between the times; a time given twice is a jump. Or the name of a text file with the columns t and load, in the working folder or beside the deck; its heading may name the unit of t. (only with [transient] end_time)
    default: constant; allowed: any text"""
    load_wave: str | os.PathLike[str]
    """Oscillating load, 'amplitude period [start]': multiplies the load by 1 + amplitude sin(2 pi (t - start)/period). (only with [transient] end_time)
    default: none; allowed: any text"""
    u1: str | os.PathLike[str]
    """Speed of surface 1 over the entrainment speed u_m of [motion] (of M and L without [motion]), written like load. The film moves with (u1 + u2)/2. Where that turns negative the oil enters at positive x; the domain must then extend equally far to both sides. (only with [transient] end_time)
    default: constant: from [motion], else 1; allowed: any text"""
    u1_wave: str | os.PathLike[str]
    """Oscillation of u1, written like load_wave. (only with [transient] end_time)
    default: none; allowed: any text"""
    u2: str | os.PathLike[str]
    """Speed of surface 2, written like u1. (only with [transient] end_time)
    default: constant: from [motion], else 1; allowed: any text"""
    u2_wave: str | os.PathLike[str]
    """Oscillation of u2, written like load_wave. (only with [transient] end_time)
    default: none; allowed: any text"""
    supply: str | os.PathLike[str]
    """Supplied oil over that of [supply] against time, written like load; it must be 1 at time 0. A layer on a surface arrives with the speed of that surface; a given flow is a thicker layer when the motion is slower. (only with [transient] end_time)
    default: constant; allowed: any text"""
    supply_wave: str | os.PathLike[str]
    """Oscillation of supply, written like load_wave. (only with [transient] end_time)
    default: none; allowed: any text"""
    cycle: str | os.PathLike[str]
    """machine: the course of the cam, the pair of teeth or the stroke that [case] kind names; end_time is then one course, in seconds, unless it is given. Or a text file with the columns t, radius_x, load, u1 and u2, of which all but t may be missing: what is missing is constant, or has its own key. Linear between the rows. In SI the columns are in m, N (line contacts: N/m) and m/s, unless the heading names other units; else they are relative to [contact] and [motion]. The scales a, p_h and u_m of the results remain those of [contact] and [motion]. (only with [transient] end_time)
    default: none; allowed: any text"""
    cycle_repeats: Literal["on", "off"] | bool
    """on: the last row repeats the first one, and the cycle begins again there. off: the table is run through once, and its last row remains. (only with [transient] cycle)
    default: on; allowed: one of on, off"""
    mode: Literal["in_time", "quasi_steady", "both"]
    """in_time: the run in time. quasi_steady: the steady state under the load, radius and speed of each row of the table by itself, as the rows of the same table of results. both: the run in time, with the quasi-steady films as columns. Where the speed is 0 there is no steady film, and no number. (only with [transient] cycle)
    default: in_time; allowed: one of in_time, quasi_steady, both"""
    stop_film: float | str
    """The run ends when the minimum film falls to this value, H = hR/a^2. (only with [transient] end_time)
    default: none; allowed: a number > 0"""
    stop_steady: float | str
    """The run ends when Hc, Hm and P_max have changed by less than this relative value during a/u_m. (only with [transient] end_time)
    default: none; allowed: a number >= 1e-12 and <= 0.1"""
    stop_periodic: float | str
    """The run ends after a period in which Hc and Hm differ from those of the period before, at the same phase, by less than this relative value. The report states the difference in any case. (only with [transient] cycle)
    default: none; allowed: a number >= 1e-08 and <= 0.1"""

class BodyKeys(TypedDict, total=False):
    """Equation of motion of a body, instead of a prescribed load. Used only with [transient]."""
    mass: float | str
    """Mass of the moving body, in F R/u_m^2. H00 then follows mass H00'' + damping H00' = load that the film carries - load that acts, both over the load of [contact]. The load that acts may be zero. (only with [transient] end_time)
    default: none: the load is prescribed; allowed: a number > 0"""
    mass_kg: float | str
    """Value of mass in kg, for a contact in SI. (only with [transient] end_time)
    default: none: the load is prescribed; allowed: a number > 0 kg"""
    damping: float | str
    """Damping of the moving body, in F R/(a u_m). (only with [transient] end_time)
    default: 0; allowed: a number >= 0"""
    damping_Nspm: float | str
    """Value of damping in N s/m, for a contact in SI. (only with [transient] end_time)
    default: 0; allowed: a number >= 0 N s/m"""
    gap: float | str
    """H00 at time 0, in a^2/R: the bodies start separated, without pressure. (only with [transient] end_time)
    default: none: the run starts from the steady film; allowed: a number > 0"""
    gap_m: float | str
    """Value of gap in m, for a contact in SI. (only with [transient] end_time)
    default: none: the run starts from the steady film; allowed: a number > 0 m"""
    velocity: float | str
    """H00' at time 0, in a u_m/R. A negative value means that the bodies approach. (only with [transient] end_time)
    default: 0; allowed: a number"""
    velocity_mps: float | str
    """Value of velocity in m/s, for a contact in SI. (only with [transient] end_time)
    default: 0; allowed: a number in m/s"""

class Surface1Keys(TypedDict, total=False):
    """Shape on surface 1. It moves through the contact in time, or stands still in a steady contact."""
    shape: Literal["dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"]
    """Shape of this surface. S is what it adds to the gap, r the distance from its centre, d that from its line. dimple: S = height exp(-(r/width)^2). bump: the same, upwards. groove and ridge: as dimple and bump, with d instead of r. waviness: S = height cos(2 pi d/width), in time only behind its front at x. cavity: S = height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2). map: measured heights from a file. In time the shape moves with its surface. In a steady contact its surface must stand still; in a dry contact all do.
    default: none; allowed: one of dimple, bump, ridge, groove, waviness, cavity, map"""
    height: float | str
    """Height, depth or amplitude, in units of a^2/R like H. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    height_m: float | str
    """Value of height in m, for a contact in SI. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    width: float | str
    """Width or wavelength, in Hertz radii a. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    width_m: float | str
    """Value of width in m, for a contact in SI. (only with [surface1] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    angle: float | str
    """Angle between the line of a ridge, groove or wave and the y axis, in degrees. 0: transverse. 90: longitudinal. (only with [surface1] shape = ridge or groove or waviness)
    default: 0; allowed: a number >= -90 and <= 90"""
    x: float | str
    """Position x of the centre at time 0, in Hertz radii. For a waviness: of a crest of the gap, in time of the first one. (only with [surface1] shape)
    default: steady: 0; in time upstream of the inlet, by three widths, one wave or half of a map; allowed: a number >= -1000 and <= 1000"""
    y: float | str
    """Position y of the centre, in Hertz radii. (only with [surface1] shape)
    default: 0; allowed: a number >= -1000 and <= 1000"""
    at_rest: Literal["yes"]
    """States that this surface stands still and the other one moves, in a steady contact given by M and L or by W, U and G. In a contact in SI, set u1 = 0 or u2 = 0 instead. (only with [surface1] shape)
    default: none; allowed: one of yes"""
    levelling: Literal["plane", "mean"]
    """What is subtracted from a map first. plane: the plane of least squares, which contains the tilt in the instrument. mean: the mean height alone. (only with [surface1] shape = map)
    default: plane; allowed: one of plane, mean"""
    longest_wave: float | str
    """Cut-off wavelength in Hertz radii of a Gaussian filter that removes longer waves. A wave of this length keeps half of its height. Without this key no long waves are removed. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    longest_wave_m: float | str
    """Value of longest_wave in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    shortest_wave: float | str
    """Cut-off wavelength in Hertz radii of a Gaussian filter that removes shorter waves. Without this key no short waves are removed. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    shortest_wave_m: float | str
    """Value of shortest_wave in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    file: str | os.PathLike[str]
    """File with the measured heights, positive out of the body, searched in the working folder, then beside the deck. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines along x, the first at the smallest y, numbers separated by semicolons, tabs, commas or blanks, with decimal points or commas; or x, y, z in every line, the points of a regular grid in any order; or Gwyddion's text, ESRI's ASCII grid, SDF of ISO 25178-71 in ASCII. A first line of words is a heading, # begins a comment. A .sur of Digital Surf. HDF5 (.h5): a dataset with rows of constant y. At least 8 by 8 points. Up to a fifth of them may be missing (an empty cell, NaN, BAD, ***); they are filled from their neighbours. The map is levelled, and averaged over the cells of the mesh. (only with [surface1] shape = map)
    default: none; allowed: any text"""
    dataset: str | os.PathLike[str]
    """Name of the dataset in a .h5 file. (only with [surface1] shape = map)
    default: height; allowed: any text"""
    unit: float | str
    """Height that the number 1 in the file stands for, in units of a^2/R like H. With unit_m: 1e-9 for a file in nanometres. Not needed if the file states its unit. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    unit_m: float | str
    """Value of unit in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    dx: float | str
    """Distance between two points of a line of the file, in Hertz radii. Not needed if the file states it. (only with [surface1] shape = map)
    default: none; allowed: a number > 0"""
    dx_m: float | str
    """Value of dx in m, for a contact in SI. (only with [surface1] shape = map)
    default: none; allowed: a number > 0 m"""
    dy: float | str
    """Distance between two lines of the file, in Hertz radii. (only with [surface1] shape = map)
    default: that of the file, else dx; allowed: a number > 0"""
    dy_m: float | str
    """Value of dy in m, for a contact in SI. (only with [surface1] shape = map)
    default: that of the file, else dx; allowed: a number > 0 m"""
    taper: float | str
    """Share of the map's length over which the heights fall to zero at each edge, by a cosine. 0: the map ends in a step. (only with [surface1] shape = map)
    default: 0.1; allowed: a number >= 0 and <= 0.5"""

class Surface2Keys(TypedDict, total=False):
    """Shape on surface 2, as for [surface1]."""
    shape: Literal["dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"]
    """Shape of this surface. S is what it adds to the gap, r the distance from its centre, d that from its line. dimple: S = height exp(-(r/width)^2). bump: the same, upwards. groove and ridge: as dimple and bump, with d instead of r. waviness: S = height cos(2 pi d/width), in time only behind its front at x. cavity: S = height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2). map: measured heights from a file. In time the shape moves with its surface. In a steady contact its surface must stand still; in a dry contact all do.
    default: none; allowed: one of dimple, bump, ridge, groove, waviness, cavity, map"""
    height: float | str
    """Height, depth or amplitude, in units of a^2/R like H. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    height_m: float | str
    """Value of height in m, for a contact in SI. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    width: float | str
    """Width or wavelength, in Hertz radii a. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0"""
    width_m: float | str
    """Value of width in m, for a contact in SI. (only with [surface2] shape = dimple or bump or ridge or groove or waviness or cavity)
    default: none; allowed: a number > 0 m"""
    angle: float | str
    """Angle between the line of a ridge, groove or wave and the y axis, in degrees. 0: transverse. 90: longitudinal. (only with [surface2] shape = ridge or groove or waviness)
    default: 0; allowed: a number >= -90 and <= 90"""
    x: float | str
    """Position x of the centre at time 0, in Hertz radii. For a waviness: of a crest of the gap, in time of the first one. (only with [surface2] shape)
    default: steady: 0; in time upstream of the inlet, by three widths, one wave or half of a map; allowed: a number >= -1000 and <= 1000"""
    y: float | str
    """Position y of the centre, in Hertz radii. (only with [surface2] shape)
    default: 0; allowed: a number >= -1000 and <= 1000"""
    at_rest: Literal["yes"]
    """States that this surface stands still and the other one moves, in a steady contact given by M and L or by W, U and G. In a contact in SI, set u1 = 0 or u2 = 0 instead. (only with [surface2] shape)
    default: none; allowed: one of yes"""
    levelling: Literal["plane", "mean"]
    """What is subtracted from a map first. plane: the plane of least squares, which contains the tilt in the instrument. mean: the mean height alone. (only with [surface2] shape = map)
    default: plane; allowed: one of plane, mean"""
    longest_wave: float | str
    """Cut-off wavelength in Hertz radii of a Gaussian filter that removes longer waves. A wave of this length keeps half of its height. Without this key no long waves are removed. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    longest_wave_m: float | str
    """Value of longest_wave in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    shortest_wave: float | str
    """Cut-off wavelength in Hertz radii of a Gaussian filter that removes shorter waves. Without this key no short waves are removed. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    shortest_wave_m: float | str
    """Value of shortest_wave in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    file: str | os.PathLike[str]
    """File with the measured heights, positive out of the body, searched in the working folder, then beside the deck. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines along x, the first at the smallest y, numbers separated by semicolons, tabs, commas or blanks, with decimal points or commas; or x, y, z in every line, the points of a regular grid in any order; or Gwyddion's text, ESRI's ASCII grid, SDF of ISO 25178-71 in ASCII. A first line of words is a heading, # begins a comment. A .sur of Digital Surf. HDF5 (.h5): a dataset with rows of constant y. At least 8 by 8 points. Up to a fifth of them may be missing (an empty cell, NaN, BAD, ***); they are filled from their neighbours. The map is levelled, and averaged over the cells of the mesh. (only with [surface2] shape = map)
    default: none; allowed: any text"""
    dataset: str | os.PathLike[str]
    """Name of the dataset in a .h5 file. (only with [surface2] shape = map)
    default: height; allowed: any text"""
    unit: float | str
    """Height that the number 1 in the file stands for, in units of a^2/R like H. With unit_m: 1e-9 for a file in nanometres. Not needed if the file states its unit. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    unit_m: float | str
    """Value of unit in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    dx: float | str
    """Distance between two points of a line of the file, in Hertz radii. Not needed if the file states it. (only with [surface2] shape = map)
    default: none; allowed: a number > 0"""
    dx_m: float | str
    """Value of dx in m, for a contact in SI. (only with [surface2] shape = map)
    default: none; allowed: a number > 0 m"""
    dy: float | str
    """Distance between two lines of the file, in Hertz radii. (only with [surface2] shape = map)
    default: that of the file, else dx; allowed: a number > 0"""
    dy_m: float | str
    """Value of dy in m, for a contact in SI. (only with [surface2] shape = map)
    default: that of the file, else dx; allowed: a number > 0 m"""
    taper: float | str
    """Share of the map's length over which the heights fall to zero at each edge, by a cosine. 0: the map ends in a step. (only with [surface2] shape = map)
    default: 0.1; allowed: a number >= 0 and <= 0.5"""

class ShearKeys(TypedDict, total=False):
    """Shear-thinning of the oil by sliding, in the film and in the friction."""
    law: Literal["eyring", "carreau"]
    """Law of shear-thinning. eyring: tau = tau_0 asinh(eta rate/tau_0). carreau: tau = eta rate [1 + (eta rate/G)^2]^((n-1)/2). Without this key the oil is Newtonian. It acts only if the surfaces slide, or with flow = on.
    default: none; allowed: one of eyring, carreau"""
    tau_0: float | str
    """Eyring stress tau_0: shear stress at which thinning begins. (only with [shear] law = eyring)
    default: none; allowed: a number > 0 and <= 1e+15 Pa"""
    G: float | str
    """Carreau stress G: shear stress at which thinning begins. (only with [shear] law = carreau)
    default: none; allowed: a number > 0 and <= 1e+15 Pa"""
    n: float | str
    """Carreau exponent n: at high shear rates the shear stress grows with the rate to the power n. (only with [shear] law = carreau)
    default: none; allowed: a number > 0 and <= 1"""
    flow: Literal["off", "on"] | bool
    """on: the flow driven by the pressure gradient also thins the oil, with sliding or without it (srr = 0), and it obeys the limit of [friction]; the film is then computed by a fixed-point iteration. off: this flow is taken to first order, without the limit. In time on is not available with [thermal]. (only with [shear] law)
    default: off; allowed: one of off, on"""

class SupplyKeys(TypedDict, total=False):
    """Starved lubrication: the surfaces bring a limited amount of oil, and cavitation conserves mass."""
    H_oil: float | str
    """Oil that both surfaces bring to the contact, in units of H: R (u1 h1 + u2 h2)/(u_m a^2). At and above the central film of the flooded contact it is nearly flooded; at a tenth of that film it is fully starved, and the layer passes through the contact.
    default: none; allowed: a number > 0"""
    layer_m: float | str
    """Thickness of the oil layer on both surfaces together, for a contact in SI.
    default: none; allowed: a number > 0 m"""
    layer1_m: float | str
    """Thickness of the oil layer on surface 1 alone, which arrives with the speed u1. Give layer1_m and layer2_m, or layer_m.
    default: none; allowed: a number >= 0 m"""
    layer2_m: float | str
    """Thickness of the oil layer on surface 2 alone, see layer1_m.
    default: none; allowed: a number >= 0 m"""
    flow_m3_per_s: float | str
    """Oil flow to the inlet, spread evenly over the width of the domain.
    default: none; allowed: a number > 0 m^3/s"""
    flow_m2_per_s: float | str
    """Oil flow to the inlet of a line contact, per length along y.
    default: none; allowed: a number > 0 m^2/s"""
    profile: str | os.PathLike[str]
    """Oil layer across the track, as a CSV file with the columns y and h (both surfaces together), in metres or in the units of its heading, y [mm] and h [nm]; in units of X and H for a contact in M and L. It must cover the width of the domain.
    default: none; allowed: any text"""
    passes: int
    """Number of successive contacts on the same track: what leaves one contact is supplied to the next. The result is that of the last one, with a table of all.
    default: 1; allowed: a whole number >= 1 and <= 10000"""
    returning: Literal["both", "surface1", "surface2"]
    """Surfaces that carry the oil of one pass to the next. The other surface brings its initial layer every time. (only with [supply] passes)
    default: both; allowed: one of both, surface1, surface2"""
    split: float | str
    """Share of the oil leaving the contact that stays on surface 1. (only with [supply] returning = surface1 or surface2)
    default: u1/(u1 + u2): equal layers on both surfaces; allowed: a number >= 0 and <= 1"""
    pass_time: float | str
    """Time from one pass to the next, used for the reflow and for the film against time. (only with [supply] passes)
    default: none; allowed: a number > 0 s"""
    reflow_time: float | str
    """Time in which differences of the layer across the track decay to 1/e, towards the mean over the width of the domain. Surface tension is far too slow for that in bearings. (only with [supply] pass_time)
    default: none: no oil flows back; allowed: a number > 0 s"""

class SubsurfaceKeys(TypedDict, total=False):
    """Stresses in the bodies below the contact; in time at the stored times, and what the material meets."""
    depth: float | str
    """Depth below the contact down to which the stresses are computed, in Hertz radii. Without this key there are no stresses. With [transient] they are computed at the stored times, and for the material of both bodies what it meets during the over-rolling.
    default: none; allowed: a number >= 0.01 and <= 1000"""
    planes: int
    """Number n of planes of constant depth, including the surface and the deepest plane. Plane k = 0..n-1 lies at (k/(n-1))^1.5 of the depth, so that planes are closer near the surface.
    default: 41; allowed: a whole number >= 3 and <= 1000"""
    cells: int
    """Largest number of cells along x of the grid for the stresses. It is the grid of the contact, halved as often as needed.
    default: 128; allowed: a whole number >= 16 and <= 1048576"""
    poisson: float | str
    """Poisson's ratio of the body whose stresses are computed.
    default: nu1 of [contact], else 0.3; allowed: a number > -1 and <= 0.5"""
    friction: float | str
    """Shear traction on the surface of the body over the pressure, positive along +x. The stresses are those of the pressure and of this traction. With [transient] it acts on body 1, and its opposite on body 2.
    default: with [friction]: the computed force on surface 1 over the load; else 0; allowed: a number >= -10 and <= 10"""
    fields: Literal["sigma_mises", "tau_max", "sigma_x", "sigma_y", "sigma_z", "tau_xy", "tau_xz", "tau_yz"] | Sequence[Literal["sigma_mises", "tau_max", "sigma_x", "sigma_y", "sigma_z", "tau_xy", "tau_xz", "tau_yz"]]
    """Stresses stored in space: sigma_mises is von Mises' equivalent stress, tau_max the largest shear stress, the others are the components. The section at y = 0 always has all of them. With [transient] these fields are those of the start.
    default: sigma_mises, tau_max; allowed: any of sigma_mises, tau_max, sigma_x, sigma_y, sigma_z, tau_xy, tau_xz, tau_yz"""

class FrictionKeys(TypedDict, total=False):
    """Friction on both surfaces, from the pressure and the film; in time at every step."""
    cavitated: Literal["none", "striated", "full"]
    """Computes the friction, with [transient] at every step, and states what the cavitated region adds to it. none: nothing. striated: oil streamers that carry the oil which left the pressurized film; the rest of the width is gas. full: an oil film that fills the whole gap.
    default: none; allowed: one of none, striated, full"""
    limit: float | str
    """Limiting shear stress over pressure, Lambda: the shear stress of sliding stays below Lambda p. Without this key there is no limit. The limit changes the friction, and with [shear] flow = on also the film, where the limit is at least tau_0 or G.
    default: none; allowed: a number > 0 and <= 10"""
    meniscus: float | str
    """Distance of the inlet meniscus from the centre of the contact, in Hertz radii. Oil fills the gap to where the undeformed gap is as wide as at this distance. Friction is counted up to it, also outside the domain; for a point contact it grows with the logarithm of the distance. The pressure is still that of a flooded contact.
    default: the radius of the bodies in the rolling direction; none for a line contact: the oil reaches to infinity; allowed: a number > 1 and <= 1e+06"""
    meniscus_m: float | str
    """Distance of the inlet meniscus from the centre of the contact, for a contact in SI.
    default: none; allowed: a number > 0 m"""
    fields: Literal["tau1", "tau2"] | Sequence[Literal["tau1", "tau2"]]
    """Shear stresses stored as fields: tau1, from the film on surface 1, and tau2, on surface 2, positive along +x. With [transient] also at every stored time.
    default: none; allowed: any of tau1, tau2"""

class ThermalKeys(TypedDict, total=False):
    """Heat in the film and in the bodies, and its effect on the film."""
    T_oil: float | str
    """Temperature of the oil that enters the contact. eta0, alpha and the other constants of the oil are values at this temperature.
    default: [lubricant] temperature, if that is given; allowed: a number >= -40 and <= 200 C"""
    beta: float | str
    """Temperature coefficient -d ln(eta)/dT at ambient pressure and T_oil, for barus (exponential) and roelands (S0 of Roelands and Houpert). T_second and eta_second, or vogel_B and vogel_C, may be given instead. kv40 with kv100, doolittle and yasutomi have their own.
    default: none; allowed: a number >= 1e-04 and <= 0.3 1/K"""
    T_second: float | str
    """Second temperature, other than T_oil, at which the viscosity is eta_second.
    default: none; allowed: a number >= -40 and <= 200 C"""
    eta_second: float | str
    """Viscosity at ambient pressure and T_second.
    default: none; allowed: a number > 0 and <= 1e+06 Pa s"""
    vogel_B: float | str
    """Constant B of Vogel's law eta = A exp[B/(T - C)].
    default: none; allowed: a number >= 1 and <= 10000 K"""
    vogel_C: float | str
    """Constant C of Vogel's law, at which the viscosity is infinite, in degrees Celsius.
    default: none; allowed: a number >= -273.15 and <= -40 C"""
    volume_expansion: float | str
    """For viscosity = doolittle: relative growth of the volume V0 per kelvin.
    default: none; allowed: a number >= 1e-05 and <= 0.01 1/K"""
    modulus_decay: float | str
    """For viscosity = doolittle: decay of the bulk modulus, K0 proportional to exp(-modulus_decay T). It equals [lubricant] beta_K if that is given.
    default: none; allowed: a number >= 1e-05 and <= 0.1 1/K"""
    occupied_expansion: float | str
    """For viscosity = doolittle: relative growth of the occupied volume R0 per kelvin.
    default: none; allowed: a number >= -0.01 and <= 0.01 1/K"""
    k: float | str
    """Thermal conductivity of the oil at ambient pressure.
    default: 0.14; allowed: a number >= 0.01 and <= 10 W/(m K)"""
    c: float | str
    """Specific heat capacity of the oil at ambient pressure.
    default: 2000; allowed: a number >= 200 and <= 10000 J/(kg K)"""
    rho: float | str
    """Density of the oil at ambient pressure and T_oil, for the heat that it carries.
    default: from density15 if that is given, else 870; allowed: a number >= 500 and <= 3000 kg/m^3"""
    properties: Literal["larsson-andersson", "constant"]
    """How k and rho c depend on pressure. larsson-andersson: they grow as those of a mineral oil, at 1 GPa to 2.1 times k and 1.3 times rho c. constant: they do not.
    default: larsson-andersson; allowed: one of larsson-andersson, constant"""
    expansion: float | str
    """Thermal expansion coefficient of the oil, -d ln(rho)/dT.
    default: 6.5e-4; allowed: a number >= 0 and <= 0.005 1/K"""
    T_body1: float | str
    """Temperature of body 1 far from the contact.
    default: T_oil; allowed: a number >= -40 and <= 200 C"""
    solid1: Literal["steel", "bk7", "glass", "sapphire", "si3n4", "al2o3", "zro2", "wc"]
    """Material of body 1, for its thermal constants only; the elastic constants are in [contact].
    default: none: k1, c1, rho1; allowed: one of steel, bk7, glass, sapphire, si3n4, al2o3, zro2, wc"""
    k1: float | str
    """Thermal conductivity of body 1, instead of solid1.
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
    """Material of body 2, for its thermal constants only; the elastic constants are in [contact].
    default: none: k2, c2, rho2; allowed: one of steel, bk7, glass, sapphire, si3n4, al2o3, zro2, wc"""
    k2: float | str
    """Thermal conductivity of body 2, instead of solid2.
    default: none; allowed: a number >= 0.05 and <= 3000 W/(m K)"""
    c2: float | str
    """Its heat capacity.
    default: none; allowed: a number >= 50 and <= 5000 J/(kg K)"""
    rho2: float | str
    """Its density.
    default: none; allowed: a number >= 500 and <= 25000 kg/m^3"""
    nodes: int
    """Number of nodes across the film; it must be odd.
    default: 17; allowed: an odd number >= 5 and <= 65"""
    convection: Literal["on", "off"] | bool
    """Whether the oil carries heat along with its flow.
    default: on; allowed: one of on, off"""
    compression: Literal["on", "off"] | bool
    """Whether compression heats the oil and expansion cools it.
    default: on; allowed: one of on, off"""
    solids: Literal["full", "lines"]
    """Model of the bodies. full: moving half-spaces, for any speed. lines: the one-dimensional model of Carslaw and Jaeger for fast bodies; the temperature rise is up to 10 % higher.
    default: full; allowed: one of full, lines"""
    fields: Literal["T_mid", "T_max", "T1", "T2", "section"] | Sequence[Literal["T_mid", "T_max", "T1", "T2", "section"]]
    """Temperatures above T_oil to store. T_mid: in the middle of the film. T_max: largest value across the film. T1, T2: on surface 1 and 2. section: T(x, z) and u(x, z) in the plane y = 0.
    default: T_mid, T_max, T1, T2; allowed: any of T_mid, T_max, T1, T2, section"""

class RollerKeys(TypedDict, total=False):
    """A roller of finite length: its profile along the axis, and its tilt."""
    profile: Literal["straight", "crowned", "logarithmic", "table"]
    """Profile of the roller along its axis. straight: with rounded ends, by end_length and end_radius. crowned: a circular arc of crown_radius. logarithmic: the profile that gives a uniform dry pressure at the design load. table: from a file. The gap ends at the ends of the roller; the bodies deform as half-spaces, which is not accurate at a sharp end. Used only with [contact] kind = roller, or with [case] kind = roller_race or gear_mesh (the face width of a tooth).
    default: none; allowed: one of straight, crowned, logarithmic, table"""
    end_length: float | str
    """Length of each rounded end of a straight roller, in half widths a. (only with [roller] profile = straight)
    default: none; allowed: a number > 0"""
    end_length_m: float | str
    """Value of end_length in m, for a contact in SI. (only with [roller] profile = straight)
    default: none; allowed: a number > 0 m"""
    end_radius: float | str
    """Radius of the rounded ends over R_x. An end falls by the square of the distance from the straight part, over twice this radius. The radius must not be smaller than end_length. (only with [roller] profile = straight)
    default: none; allowed: a number > 0"""
    end_radius_m: float | str
    """Value of end_radius in m, for a contact in SI. (only with [roller] profile = straight)
    default: none; allowed: a number > 0 m"""
    crown_radius: float | str
    """Radius of a crowned roller along its axis, over R_x. It must be at least half of the roller's length. (only with [roller] profile = crowned)
    default: none; allowed: a number > 0"""
    crown_radius_m: float | str
    """Value of crown_radius in m, for a contact in SI. (only with [roller] profile = crowned)
    default: none; allowed: a number > 0 m"""
    design_load: float | str
    """Load for which a logarithmic profile is designed, over the load of the contact. (only with [roller] profile = logarithmic)
    default: the load of the contact; allowed: a number > 0 and <= 10"""
    design_load_N: float | str
    """Value of design_load in N, for a contact in SI. (only with [roller] profile = logarithmic)
    default: the load of the contact; allowed: a number > 0 N"""
    shortest_wave: float | str
    """Cut-off wavelength of a measured profile, in half widths a. A Gaussian filter removes shorter waves; a wave of this length keeps half of its height. The form is kept up to the ends. Without this key the profile is not filtered. (only with [roller] profile = table)
    default: none; allowed: a number > 0"""
    shortest_wave_m: float | str
    """Value of shortest_wave in m, for a contact in SI. (only with [roller] profile = table)
    default: none; allowed: a number > 0 m"""
    levelling: Literal["none", "line"]
    """What is subtracted from a measured profile. none: nothing. line: the straight line of least squares, which is the tilt of the roller in the instrument. (only with [roller] profile = table)
    default: none; allowed: one of none, line"""
    file: str | os.PathLike[str]
    """Profile as a table with the columns y and drop, the distance by which the surface lies below the middle of the roller, in m; in a and a^2/R for a contact without units. A heading may name other units, y [mm] and drop [um]. It needs at least four rows with rising y, from end to end or from the middle to one end (then mirrored), and must not reach beyond ten times half of the length. Values between the rows are interpolated smoothly. (only with [roller] profile = table)
    default: none; allowed: any text"""
    tilt: float | str
    """Misalignment of the roller, as the slope dH/dY of the gap; the unit is a/R of an angle. The gap opens towards y > 0. At least a tenth of the roller's length must carry load, estimated by a slice model. (only with [roller] profile)
    default: 0; allowed: a number >= -100 and <= 100"""
    tilt_mrad: float | str
    """Value of tilt in mrad, for a contact in SI. (only with [roller] profile)
    default: none; allowed: a number >= -100 and <= 100 mrad"""

class MixedKeys(TypedDict, total=False):
    """Mixed lubrication: rough or smooth surfaces that touch where the film falls to a boundary film."""
    h_b: float | str
    """Thickness of the boundary film that remains between surfaces that touch, for a contact in SI: the adsorbed layer. The gap is nowhere thinner; where it is this thin the surfaces carry load by a contact pressure in addition to that of the oil. With this key asperity contact is part of a steady point, elliptic or line contact. Not available with [transient], [thermal], [supply], [shear] flow = on, rollers, or [grid] accuracy.
    default: none; allowed: a number > 0 and <= 1e-06 m"""
    H_b: float | str
    """The same in units of H: h_b R/a^2. For a contact in M and L.
    default: none; allowed: a number > 0"""
    mu_b: float | str
    """Friction coefficient of the boundary film where the surfaces touch. [friction] then has a boundary part, mu_b times the load share of the contact.
    default: none; allowed: a number >= 0 and <= 2"""
    hardness: float | str
    """Hardness of the softer surface: largest contact pressure. Where it is reached, the surface yields by as much as keeps the gap at the boundary film.
    default: none: the bodies stay elastic; allowed: a number > 0 Pa"""

class OutputKeys(TypedDict, total=False):
    """The result file and what it contains."""
    file: str | os.PathLike[str]
    """Name of the result file (HDF5). --output has precedence.
    default: name of the deck with the ending .h5; allowed: any text"""
    fields: Literal["P", "H", "rho_bar", "ln_eta_bar", "error_map_Hc", "error_map_Hm"] | Sequence[Literal["P", "H", "rho_bar", "ln_eta_bar", "error_map_Hc", "error_map_Hm"]]
    """Fields to store. P: pressure. H: film thickness. rho_bar: density. ln_eta_bar: logarithm of the viscosity. error_map_Hc, error_map_Hm: maps of the contributions to the discretization errors of Hc and Hm, with [grid] errors = adjoint and wedge = upstream3.
    default: P, H; allowed: any of P, H, rho_bar, ln_eta_bar, error_map_Hc, error_map_Hm"""
    checkpoint: float | str
    """Wall-clock time between two checkpoints of a run in time. `ehl resume` continues from the last checkpoint in the result file. (only with [transient] end_time)
    default: 60 for a run in time; allowed: a number > 0 s"""
    probe: str | os.PathLike[str]
    """Points 'X Y, X Y, ...' in Hertz radii at which a run in time stores P and H at every step, as the columns P_1, H_1, P_2, ... of /transient. The value is that of the node at the point, else bicubic interpolation with P >= 0. (only with [transient] end_time)
    default: none; allowed: any text"""

def run(
    deck: Deck,
    *,
    threads: int | None = None,
    progress: Callable[[float, str], bool | None] | None = None,
    case: CaseKeys = ...,
    bearing: BearingKeys = ...,
    gear: GearKeys = ...,
    cam: CamKeys = ...,
    stroke: StrokeKeys = ...,
    impact: ImpactKeys = ...,
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
    mixed: MixedKeys = ...,
    output: OutputKeys = ...,
) -> Result: ...

def check(
    deck: Deck,
    *,
    threads: int | None = None,
    case: CaseKeys = ...,
    bearing: BearingKeys = ...,
    gear: GearKeys = ...,
    cam: CamKeys = ...,
    stroke: StrokeKeys = ...,
    impact: ImpactKeys = ...,
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
    mixed: MixedKeys = ...,
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
    cam: CamKeys = ...,
    stroke: StrokeKeys = ...,
    impact: ImpactKeys = ...,
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
    mixed: MixedKeys = ...,
    output: OutputKeys = ...,
) -> pd.DataFrame: ...
