# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Optimal transport between mass distributions, and fields."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import InvalidArgumentError
from ._distances import Distances, Path, SurfelPath
from ._types import Callback, Floats, Integers, ManyLocations


class MassDensity(NamedTuple):
    """A mass distribution with a density. See ``mass_density()``."""

    values: ArrayLike
    """Shape (n,): mass per area at each vertex, per squared unit of the coordinates."""


Masses = Union[ManyLocations, NDArray[np.floating[Any]], Sequence[float], MassDensity]


def mass_density(values: ArrayLike) -> MassDensity:
    """Returns a mass distribution whose density is linear in each triangle.

    Parameters
    ----------
    values
        Shape (n,), finite: mass per area at each vertex, per squared unit of the coordinates.
    """
    return MassDensity(values)


class TransportCost(NamedTuple):
    """The cost of a transport with certified bounds: mass times length, or times travel time."""

    value: float
    """The mean of the lower and the upper bound."""
    lower: float
    """A certified lower bound, also of the cost by geodesic distances on the surface."""
    upper: float
    """A certified upper bound of the cost by flows that are constant in each face."""
    upper_continuous: float
    """A certified upper bound of the cost by flows on the surface; infinite unless
    ``bound_from_above`` is set."""
    estimate: float
    """The value extrapolated from two refinement levels, not certified; without refinement the
    same as ``value``."""
    number_of_iterations: int
    """The number of iterations on the finest level."""
    residual: float
    """The largest difference of the divergence of the flow and the masses, relative to the total
    mass that is moved."""
    is_converged: bool
    """Whether the gap between the bounds is within the tolerance."""


class Transport(NamedTuple):
    """A transport between two mass distributions."""

    cost: TransportCost
    """The cost with certified bounds."""
    potential: Floats | None
    """Shape (n,): the function of slope at most one that certifies the lower bound. It increases
    along the flow. None if the flow is restricted to a basis."""
    flow: Floats
    """Shape (m, 3) for the faces of a mesh, (n, 3) for the surfels of a cloud: mass per unit length
    of a line across the flow. NaN if the cost is infinite."""
    basis_size: int | None
    """The number of eigenfunctions: ``basis``, rounded up to the next gap between eigenvalues. None
    if the flow is not restricted."""


class RegionTransport(NamedTuple):
    """A transport of a mass distribution to a region."""

    cost: TransportCost
    """The cost with certified bounds."""
    arrivals: Floats
    """Shape (n,): the mass that arrives at each vertex."""
    potential: Floats
    """Shape (n,): the function that certifies the lower bound. Without limits, it is zero in the
    region, and its absolute value is a lower bound of the distance to the region."""
    flow: Floats
    """As for ``Transport``."""


class TransportBarycenter(NamedTuple):
    """A barycenter of mass distributions with certified bounds of its cost, which is the weighted
    sum of squared earth mover's distances."""

    value: float
    """The mean of the lower and the upper bound."""
    lower: float
    """A certified lower bound of the cost of every mass distribution."""
    upper: float
    """A certified upper bound of the cost of the computed barycenter, by flows that are constant
    in each face."""
    distances: Floats
    """Shape (k,): the upper bound of the distance to each of the given distributions."""
    number_of_iterations: int
    """The number of iterations."""
    residual: float
    """The largest difference of the divergence of a flow and its masses, relative to the total
    mass."""
    is_converged: bool
    """Whether the gap between the bounds is within the tolerance."""
    masses: Floats
    """Shape (n,): the mass of the barycenter at each vertex."""
    density: Floats
    """Shape (n,): the mass divided by a third of the area of the incident triangles."""


class GeodesicBarycenter(NamedTuple):
    """The vertex with the smallest weighted sum of squared distances."""

    vertex: int
    """The vertex."""
    value: float
    """The weighted sum of squared distances there."""
    objective: Floats
    """Shape (n,): the weighted sum of squared distances at each vertex; infinite if a location with
    positive weight does not reach it."""


class Streamline(NamedTuple):
    """A path along which a flow transports mass."""

    path: Path | SurfelPath
    """The path. Its ``distance`` is the increase of the potential from its start to its end. If
    these ends are vertices, no path between them is shorter."""
    has_arrived: bool
    """Whether it ends at a target mass."""


class HodgeDecomposition(NamedTuple):
    """The orthogonal components of a field of tangent vectors on a mesh, and their potentials."""

    gradient: Floats
    """Shape (m, 3): the component with sources and sinks, the gradient of
    ``gradient_potential``."""
    rotation: Floats
    """Shape (m, 3): the component with vortices, the gradient of ``rotation_potential``, rotated
    counterclockwise by a right angle."""
    harmonic: Floats
    """Shape (m, 3): the remainder, which winds around handles and holes."""
    gradient_potential: Floats
    """Shape (n,): a function that is linear in each face. Its integral over each component is
    zero."""
    edges: Integers
    """Shape (e, 2): the vertices of each edge."""
    rotation_potential: Floats
    """Shape (e,): the values at the midpoints of ``edges`` of a function that is linear in each
    face. It is zero on the boundary."""
    vertex_rotation_potential: Floats
    """Shape (n,): the continuous function, zero on the boundary and linear in each face, whose
    rotated gradient is closest to the field."""


class SurfelHodgeDecomposition(NamedTuple):
    """The components of a field of tangent vectors on a cloud."""

    gradient: Floats
    """Shape (n, 3): the gradient of ``gradient_potential``."""
    remainder: Floats
    """Shape (n, 3): the other components, which the triangles of a cloud do not separate."""
    gradient_potential: Floats
    """Shape (n,): the function whose gradient is closest to the field."""


class Transports(Distances):
    """The functions of a surface for transport and for fields.

    A mass distribution is one of the following:

    - a location, or a range of locations: unit mass in equal parts
    - an array of float64 or float32 of the shape (n,), or a list of n floats: the mass at each
      vertex
    - the result of ``mass_density()``
    """

    def emd(
        self,
        a: Masses,
        b: Masses,
        basis: int | None = None,
        *,
        method: str = "interior-point",
        transport_flow: str | None = None,
        tolerance: float = 1e-3,
        max_iterations: int | None = None,
        normalize: bool = False,
        bound_from_above: bool = False,
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        metric: ArrayLike | None = None,
        face_metric: ArrayLike | None = None,
        number_of_refinements: int | None = None,
        callback: Callback | None = None,
    ) -> Transport:
        """Computes the earth mover's distance (1-Wasserstein distance) of two mass distributions.

        Parameters
        ----------
        a, b
            Mass distributions with the same total mass on each component: a location or a range of
            locations (unit mass in equal parts), an array of floats of the shape (n,) (the mass at
            each vertex), or the result of ``mass_density()``.
        basis
            A number of eigenfunctions. The flow is restricted to the span of their rotated
            gradients, the harmonic fields and a particular flow. The distance is then between a
            smooth and the geodesic one. By default, all flows are admitted.
        method
            - ``"interior-point"``: few iterations with a factorization each; reaches any tolerance
            - ``"admm"``: many cheap iterations; for tolerances of about 0.01
            - ``"weiszfeld"``: for comparison
        transport_flow
            The particular flow of a basis, ``"gradient"`` or ``"balanced"``. By default, balanced
            if ``basis`` is positive.
        tolerance
            The gap between the bounds, relative to the upper bound, at which the iteration ends.
        max_iterations
            The maximum number of iterations on each level. By default 100; 5,000 for ``"admm"`` or
            a basis.
        normalize
            Whether both distributions are scaled to a total mass of one.
        bound_from_above
            Whether ``upper_continuous`` is computed, which takes a few times as long; on meshes
            only.
        speed
            Shape (n,): the speed at the vertices. The cost of a path is its travel time.
        face_speed
            Shape (m,): the speed in the faces of a mesh, instead of ``speed``.
        metric
            Shape (n, 3, 3): a symmetric positive definite matrix M for each vertex. The length of a
            vector v is the square root of v^T M v, divided by the speed.
        face_metric
            Shape (m, 3, 3): such a matrix for each face of a mesh, instead of ``metric``.
        number_of_refinements
            The number of 1-to-4 subdivisions of each triangle. Each halves the error and takes four
            to eight times as long. By default 1 up to 5,000 vertices, otherwise 0.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the total masses differ on a component.
        UnsupportedSurfaceError
            If no triangle has an area, or if the refined surface is too large.
        Cancelled
            If the callback returns a false value.

        Takes two factorizations and 5 to 20 iterations of O(n^1.5) time. With a basis, constructing
        it takes about as long as 2.5 ``basis`` solutions of Poisson's equation.
        """
        from_masses, to_masses = _distribution(a), _distribution(b)
        setup = self._setup(speed, face_speed, metric, face_metric, number_of_refinements)
        if basis is None:
            if transport_flow is not None:
                raise InvalidArgumentError("transport_flow needs a basis.")
            query = _query(method, tolerance, max_iterations, normalize, bound_from_above)
            cost, potential, flow = self._core.emd(from_masses, to_masses, setup, query, callback)
            return Transport(TransportCost(*cost), potential, flow, None)
        if method != "interior-point" or bound_from_above or any(x is not None for x in setup):
            raise InvalidArgumentError(
                "basis cannot be combined with method, bound_from_above, number_of_refinements, "
                "speeds and metrics."
            )
        cost, flow, size = self._core.spectral_emd(
            from_masses,
            to_masses,
            basis,
            transport_flow,
            tolerance,
            5000 if max_iterations is None else max_iterations,
            bool(normalize),
            callback,
        )
        return Transport(TransportCost(*cost), None, flow, size)

    def barycenter(
        self,
        masses: Iterable[Masses],
        weights: ArrayLike | None = None,
        *,
        tolerance: float = 0.01,
        max_iterations: int = 5000,
        normalize: bool = False,
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        metric: ArrayLike | None = None,
        face_metric: ArrayLike | None = None,
        number_of_refinements: int | None = None,
        callback: Callback | None = None,
    ) -> TransportBarycenter:
        """Computes the barycenter of mass distributions.

        It is the nonnegative distribution that minimizes the weighted sum of squared earth mover's
        distances to the given ones. It is not unique; the cost is. If the barycenter must be a
        point, use ``geodesic_barycenter()``.

        Parameters
        ----------
        masses
            Nonnegative mass distributions as for ``emd()``, for example the rows of an array of
            floats of the shape (k, n), or a list of vertices with unit masses.
        weights
            Shape (k,): the weights of the distributions, not negative and not all zero. By default
            1 for each.
        max_iterations
            The maximum number of iterations.
        tolerance, normalize, speed, face_speed, metric, face_metric, \
number_of_refinements, callback
            As for ``emd()``.

        Takes two factorizations, and some hundred iterations of O(k n log n) time.
        """
        if not isinstance(masses, Iterable) or isinstance(masses, MassDensity):
            raise InvalidArgumentError("masses are not a range of mass distributions.")
        arrays = self._core.barycenter(
            [_distribution(item) for item in masses],
            weights,
            self._setup(speed, face_speed, metric, face_metric, number_of_refinements),
            tolerance,
            max_iterations,
            bool(normalize),
            callback,
        )
        return TransportBarycenter(*arrays)

    def geodesic_barycenter(
        self,
        locations: ManyLocations,
        weights: ArrayLike | None = None,
        *,
        method: str = "auto",
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> GeodesicBarycenter:
        """Computes the vertex that minimizes the weighted sum of squared distances to locations.

        Parameters
        ----------
        locations
            A location, or a range of k locations.
        weights
            Shape (k,): the weights of the locations, not negative and not all zero. By default 1
            for each.
        method, speed, face_speed
            As for ``distance()``.
        callback
            A function that takes the completed fraction of the distances of one location.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if no vertex is reached from all locations.

        Takes one distance computation for each location.
        """
        return GeodesicBarycenter(
            *self._core.geodesic_barycenter(
                locations, weights, method, speed, face_speed, callback
            )
        )

    def transport_to_region(
        self,
        masses: Masses,
        region: ManyLocations,
        *,
        capacities: ArrayLike | None = None,
        spreading_weight: float = 0.0,
        method: str = "interior-point",
        tolerance: float = 1e-3,
        max_iterations: int | None = None,
        normalize: bool = False,
        bound_from_above: bool = False,
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        metric: ArrayLike | None = None,
        face_metric: ArrayLike | None = None,
        number_of_refinements: int | None = None,
        callback: Callback | None = None,
    ) -> RegionTransport:
        """Computes the minimum cost of moving masses to a region.

        Each mass arrives where this is cheapest. Moving within the region costs nothing, unless
        there are capacities or a spreading weight.

        Parameters
        ----------
        masses
            A mass distribution as for ``emd()``.
        region
            A location, or a range of k locations: the exits.
        capacities
            Shape (k,): the maximum mass that can arrive at each exit: positive, infinite for no
            limit. By default, there are no limits.
        spreading_weight
            The integral of the squared density of arriving mass, times this weight, is added to the
            cost.
        method
            As for ``emd()``; only ``"interior-point"`` if there are capacities or a spreading
            weight.
        tolerance, max_iterations, normalize, bound_from_above, speed, face_speed, metric, \
face_metric, number_of_refinements, callback
            As for ``emd()``.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, if a component with mass has no exit, or if the capacities
            are too small.

        Takes two factorizations and 10 to 25 iterations of O(n^1.5) time.
        """
        cost, *arrays = self._core.transport_to_region(
            _distribution(masses),
            region,
            capacities,
            spreading_weight,
            self._setup(speed, face_speed, metric, face_metric, number_of_refinements),
            _query(method, tolerance, max_iterations, normalize, bound_from_above),
            callback,
        )
        return RegionTransport(TransportCost(*cost), *arrays)

    def streamlines(
        self,
        a: Masses,
        b: Masses,
        n: int | None = None,
        *,
        seeds: ManyLocations | None = None,
        straighten: bool = True,
        method: str = "interior-point",
        tolerance: float = 1e-3,
        max_iterations: int | None = None,
        normalize: bool = False,
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        metric: ArrayLike | None = None,
        face_metric: ArrayLike | None = None,
        number_of_refinements: int | None = None,
        callback: Callback | None = None,
    ) -> list[Streamline]:
        """Computes the streamlines along which one mass distribution is transported to another.

        Parameters
        ----------
        a, b
            Mass distributions as for ``emd()``.
        n
            The number of streamlines, each for an equal part of the mass.
        seeds
            The locations at which streamlines begin, instead of ``n``.
        straighten
            Whether lines are shortened to geodesics; ignored if there is a metric, or a speed that
            is neither zero nor one.
        method, tolerance, max_iterations, normalize, speed, face_speed, metric, face_metric, \
number_of_refinements, callback
            As for ``emd()``.

        Takes about twice as long as ``emd()``, and O(number of crossed faces) for each streamline.
        """
        if (n is None) == (seeds is None):
            raise InvalidArgumentError("Either n or seeds is required.")
        lines = self._core.streamlines(
            _distribution(a),
            _distribution(b),
            n,
            seeds,
            bool(straighten),
            self._setup(speed, face_speed, metric, face_metric, number_of_refinements),
            _query(method, tolerance, max_iterations, normalize, False),
            callback,
        )
        return [Streamline(self._path(path), has_arrived) for path, has_arrived in lines]

    def hodge_decomposition(
        self, field: ArrayLike
    ) -> HodgeDecomposition | SurfelHodgeDecomposition:
        """Decomposes a field of tangent vectors into gradient, rotation and harmonic component.

        On each component of a mesh, the harmonic fields have the dimension
        ``2 * genus + max(b - 1, 0)`` for b boundary cycles. On a cloud, only the gradient is
        separated.

        Parameters
        ----------
        field
            Shape (m, 3) for the faces of a mesh, (n, 3) for the surfels of a cloud, finite. The
            normal component is ignored.

        Takes three factorizations on a mesh, one on a cloud.
        """
        if isinstance(self._core, _core.Cloud):
            return SurfelHodgeDecomposition(*self._core.hodge_decomposition(field))
        return HodgeDecomposition(*self._core.hodge_decomposition(field))

    def _setup(
        self,
        speed: Any,
        face_speed: Any,
        metric: Any,
        face_metric: Any,
        number_of_refinements: Any,
    ) -> tuple[Any, Any, Any, Any, Any]:
        """Collects the arguments of the construction of a solver. Matrices become rows."""
        return (
            speed,
            face_speed,
            _rows_of_matrices(metric, "metric", self.number_of_points),
            _rows_of_matrices(face_metric, "face_metric", self.number_of_faces),
            number_of_refinements,
        )


def _distribution(masses: Any) -> tuple[bool, Any]:
    """Returns whether a mass distribution is a density, and its values."""
    if isinstance(masses, MassDensity):
        return True, masses.values
    return False, masses


def _query(
    method: Any, tolerance: Any, max_iterations: Any, normalize: Any, bound_from_above: Any
) -> tuple[Any, Any, Any, bool, bool]:
    """Collects the arguments of a query of a solver."""
    if max_iterations is None:
        max_iterations = 5000 if method == "admm" else 100
    return method, tolerance, max_iterations, bool(normalize), bool(bound_from_above)


def _rows_of_matrices(matrices: Any, name: str, size: int) -> Any:
    """Returns an array of the shape (size, 9)."""
    if matrices is None:
        return None
    array = np.asarray(matrices)
    if array.shape != (size, 3, 3):
        raise InvalidArgumentError(
            f"{name} has the shape {array.shape}, but its shape must be {(size, 3, 3)}."
        )
    return array.reshape(size, 9)
