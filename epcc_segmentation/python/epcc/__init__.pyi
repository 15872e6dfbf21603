# SPDX-License-Identifier: BSD-3-Clause
# Types of the module epcc, held against it by tests/python/stubs_test.py. help(epcc.NAME) has units, ranges and errors.
from typing import Any, Callable, Dict, List, Literal, Optional, Sequence, Tuple, Union, overload

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

_Frame = Union[DepthFrame, NDArray[numpy.float32], NDArray[numpy.uint16]]
_Values = Union[NDArray[numpy.float32], NDArray[numpy.uint16]]
_Sensor = Union[SensorModel, str, None]
_Projection = Literal["perspective", "perspective-backward", "spherical"]
_Doubles = NDArray[numpy.float64]

# Errors

class Status:
    OK: Status
    NO_INPUT: Status
    EMPTY_CLOUD: Status
    SIZE_MISMATCH: Status
    UNORGANIZED: Status
    INVALID_INDICES: Status
    INVALID_CAMERA: Status
    INVALID_PARAMETERS: Status
    UNSUPPORTED_SCAN: Status
    UNKNOWN_GEOMETRY: Status
    OUT_OF_MEMORY: Status
    FAILED: Status
    OUT_OF_ORDER: Status
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class EpccError(RuntimeError):
    status: Optional[Status]

class InputError(EpccError, ValueError): ...
class OutOfMemoryError(EpccError, MemoryError): ...

# Frames

class PinholeCamera:
    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float
    def __init__(self, width: int, height: int, fx: float, fy: float, cx: float, cy: float) -> None: ...
    def validate(self) -> None: ...

class DepthFrame:
    @staticmethod
    def from_depth(
        depth: Union[NDArray[numpy.float32], NDArray[numpy.uint16]],
        camera: PinholeCamera,
        depth_scale: Optional[float] = ...,
        *,
        is_distance: bool = ...,
        invalid: Optional[float] = ...,
        min_depth: float = ...,
        max_depth: float = ...,
    ) -> DepthFrame: ...
    @staticmethod
    def from_points(
        points: NDArray[numpy.float32], options: CloudOptions = ..., *, geometry: Optional[CloudGeometry] = ...
    ) -> DepthFrame: ...
    def masked(self, mask: Union[NDArray[numpy.bool_], NDArray[numpy.uint8]]) -> DepthFrame: ...
    def points(self) -> NDArray[numpy.float32]: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def projection(self) -> _Projection: ...
    @property
    def geometry(self) -> Optional[CloudGeometry]: ...

# Clouds: how they were measured

class SensorPose:
    def __init__(self, axes: ArrayLike, origin: ArrayLike) -> None: ...
    @property
    def axes(self) -> _Doubles: ...
    @property
    def origin(self) -> _Doubles: ...

class CloudOptions:
    sensor: Literal["any", "camera", "scanner"]
    projection: Optional[_Projection]
    unit: float
    min_depth: float
    max_depth: float
    invalid: Optional[float]
    viewpoint: Optional[SensorPose]
    def __init__(
        self,
        *,
        sensor: Literal["any", "camera", "scanner"] = ...,
        projection: Optional[_Projection] = ...,
        unit: float = ...,
        min_depth: float = ...,
        max_depth: float = ...,
        invalid: Optional[float] = ...,
        viewpoint: Optional[SensorPose] = ...,
    ) -> None: ...

class ScanGrid:
    @property
    def rings_are_columns(self) -> bool: ...
    @property
    def ring_order(self) -> List[int]: ...
    @property
    def ring_shift(self) -> List[int]: ...
    @property
    def margin(self) -> int: ...
    @property
    def closes_round(self) -> bool: ...

class CloudGeometry:
    @property
    def is_plain(self) -> bool: ...
    @property
    def projection(self) -> _Projection: ...
    @property
    def pose(self) -> SensorPose: ...
    @property
    def unit(self) -> float: ...
    @property
    def unit_is_guessed(self) -> bool: ...
    @property
    def grid(self) -> ScanGrid: ...
    @property
    def residual(self) -> float: ...
    @property
    def invalid_points(self) -> NDArray[numpy.float32]: ...
    @property
    def min_depth(self) -> float: ...
    @property
    def max_depth(self) -> float: ...

class GeometryFinder:
    def __init__(self) -> None: ...
    def find(self, points: NDArray[numpy.float32], options: CloudOptions = ...) -> CloudGeometry: ...

def find_geometry(points: NDArray[numpy.float32], options: CloudOptions = ...) -> CloudGeometry: ...

# The sensor

class SensorModel:
    @staticmethod
    def polynomial(k1: float, k2: float, k3: float, correlation_length: float = ...) -> SensorModel: ...
    @staticmethod
    def axial(a: float, b: float, correlation_length: float = ...) -> SensorModel: ...
    @staticmethod
    def preset(name: str) -> SensorModel: ...
    @staticmethod
    def preset_names() -> List[str]: ...
    @staticmethod
    def parse(text: str) -> SensorModel: ...
    @overload
    def sigma_z(self, z: float) -> float: ...
    @overload
    def sigma_z(self, z: Union[NDArray[Any], Sequence[float]]) -> _Doubles: ...
    @overload
    def variance_z(self, z: float) -> float: ...
    @overload
    def variance_z(self, z: Union[NDArray[Any], Sequence[float]]) -> _Doubles: ...
    @overload
    def sigma_inverse_depth(self, z: float) -> float: ...
    @overload
    def sigma_inverse_depth(self, z: Union[NDArray[Any], Sequence[float]]) -> _Doubles: ...
    @property
    def is_polynomial(self) -> bool: ...
    @property
    def coefficients(self) -> Tuple[float, float, float]: ...
    @property
    def correlation_length(self) -> float: ...
    @property
    def correlated_share(self) -> float: ...
    @property
    def pixels_per_sample(self) -> float: ...
    @property
    def pixels_per_line_sample(self) -> float: ...
    def with_correlation_length(self, length: float) -> SensorModel: ...
    def with_correlated_share(self, share: float) -> SensorModel: ...
    def scaled(self, factor: float) -> SensorModel: ...
    @property
    def description(self) -> str: ...

class SensorEstimate:
    @property
    def a(self) -> float: ...
    @property
    def b(self) -> float: ...
    @property
    def correlation_length(self) -> float: ...
    @property
    def blotch_length(self) -> float: ...
    @property
    def blotch_share(self) -> float: ...
    @property
    def effective_length(self) -> float: ...
    @property
    def correlated_share(self) -> float: ...
    @property
    def blocks(self) -> int: ...
    def model(self) -> SensorModel: ...

class SensorMeasurement:
    @property
    def estimate(self) -> SensorEstimate: ...
    @property
    def blocks(self) -> NDArray[numpy.void]: ...
    @property
    def bins(self) -> NDArray[numpy.void]: ...
    @property
    def grain(self) -> float: ...
    @property
    def blotches(self) -> float: ...
    @property
    def sides(self) -> List[int]: ...
    @property
    def kept(self) -> List[float]: ...
    @property
    def kept_fit(self) -> List[float]: ...
    @property
    def correlation(self) -> _Doubles: ...
    @property
    def correlation_fit(self) -> _Doubles: ...

def estimate_sensor(
    frame: _Frame, camera: Optional[PinholeCamera] = ..., depth_scale: Optional[float] = ...
) -> SensorEstimate: ...

class SensorEstimator:
    def __init__(self, memory: int = ..., interval: int = ...) -> None: ...
    def update(
        self, frame: _Frame, camera: Optional[PinholeCamera] = ..., depth_scale: Optional[float] = ...
    ) -> SensorEstimate: ...
    def reset(self) -> None: ...

class SensorPool:
    def __init__(self) -> None: ...
    def add(self, frame: _Frame, camera: Optional[PinholeCamera] = ..., depth_scale: Optional[float] = ...) -> bool: ...
    @property
    def frames(self) -> int: ...
    def measure(self) -> SensorMeasurement: ...

# Results

class Plane:
    @property
    def coefficients(self) -> _Doubles: ...
    @property
    def coefficients_covariance(self) -> _Doubles: ...
    @property
    def centroid(self) -> _Doubles: ...
    @property
    def points_covariance(self) -> _Doubles: ...
    @property
    def rms(self) -> float: ...
    @property
    def pixel_count(self) -> int: ...
    @property
    def confidence(self) -> float: ...
    def signed_distance(self, points: ArrayLike) -> Any: ...
    def project(self, points: ArrayLike) -> _Doubles: ...

class PixelContour:
    @property
    def points(self) -> NDArray[numpy.int32]: ...
    @property
    def is_hole(self) -> bool: ...
    @property
    def signed_area(self) -> float: ...

def trace_contours(labels: NDArray[Any], label: int) -> List[PixelContour]: ...
def trace_all_contours(labels: NDArray[Any], label_count: int) -> List[List[PixelContour]]: ...

class StageTimes:
    @property
    def read(self) -> float: ...
    @property
    def sensor(self) -> float: ...
    @property
    def lines(self) -> float: ...
    @property
    def planes(self) -> float: ...
    @property
    def regions(self) -> float: ...
    @property
    def result(self) -> float: ...
    @property
    def total(self) -> float: ...

class Doubts:
    @property
    def sensor_is_generic(self) -> bool: ...
    @property
    def error_share(self) -> float: ...
    @property
    def jump_share(self) -> float: ...
    @property
    def scattered_share(self) -> float: ...
    @property
    def limit_share(self) -> float: ...
    @property
    def limit_depth(self) -> float: ...
    @property
    def bytes_are_swapped(self) -> bool: ...
    def any(self) -> bool: ...
    def in_words(self) -> str: ...

class PlaneSegmentation:
    @property
    def labels(self) -> NDArray[numpy.int32]: ...
    @property
    def planes(self) -> List[Plane]: ...
    @property
    def segments(self) -> NDArray[numpy.void]: ...
    def contours(self, label: int) -> List[PixelContour]: ...
    def all_contours(self) -> List[List[PixelContour]]: ...
    @property
    def sensor(self) -> SensorModel: ...
    @property
    def doubts(self) -> Doubts: ...
    @property
    def times(self) -> StageTimes: ...
    @property
    def geometry(self) -> Optional[CloudGeometry]: ...

# Segmentation

class PlaneExtractor:
    def __init__(self, parameters: Optional[Parameters] = ..., sensor: _Sensor = ...) -> None: ...
    def extract(
        self, frame: _Frame, camera: Optional[PinholeCamera] = ..., depth_scale: Optional[float] = ...
    ) -> PlaneSegmentation: ...
    parameters: Parameters
    @property
    def sensor(self) -> SensorModel: ...
    @sensor.setter
    def sensor(self, sensor: _Sensor) -> None: ...
    @property
    def measures_sensor(self) -> bool: ...

def segment(
    frame: _Frame,
    camera: Optional[PinholeCamera] = ...,
    parameters: Optional[Parameters] = ...,
    sensor: _Sensor = ...,
    *,
    depth_scale: Optional[float] = ...,
) -> PlaneSegmentation: ...
def fit_planes(frame: DepthFrame, sensor: _Sensor, labels: NDArray[Any]) -> PlaneSegmentation: ...
def fit_lines(frame: DepthFrame, sensor: _Sensor, labels: NDArray[Any]) -> PlaneSegmentation: ...

# Planes over time

class PlaneTrack:
    @property
    def label(self) -> int: ...
    @property
    def coefficients(self) -> _Doubles: ...
    @property
    def coefficients_covariance(self) -> _Doubles: ...
    @property
    def centroid(self) -> _Doubles: ...
    @property
    def first_frame(self) -> int: ...
    @property
    def last_frame(self) -> int: ...
    @property
    def first_time(self) -> float: ...
    @property
    def last_time(self) -> float: ...
    @property
    def frames(self) -> int: ...
    @property
    def confidence(self) -> float: ...
    @property
    def end(self) -> str: ...
    @property
    def merged_into(self) -> int: ...

class TrackedFrame:
    @property
    def labels(self) -> NDArray[numpy.int32]: ...
    @property
    def label_of_plane(self) -> NDArray[numpy.int32]: ...
    @property
    def track_of_plane(self) -> List[int]: ...
    @property
    def segmentation(self) -> PlaneSegmentation: ...
    @property
    def pose(self) -> _Doubles: ...
    @property
    def pose_covariance(self) -> _Doubles: ...
    @property
    def pose_information(self) -> _Doubles: ...
    def open_directions(self, sigma: float = ...) -> List[_Doubles]: ...
    @property
    def pose_jumped(self) -> bool: ...
    @property
    def squared_error(self) -> List[float]: ...

class PlaneTracker:
    def __init__(
        self,
        parameters: Optional[Parameters] = ...,
        sensor: _Sensor = ...,
        *,
        pose_offset_sigma: float = ...,
        pose_angle_sigma: float = ...,
        motion_offset_sigma: float = ...,
        motion_angle_sigma: float = ...,
        confirm_frames: int = ...,
        search_frames: int = ...,
        memory_frames: int = ...,
    ) -> None: ...
    def track(
        self,
        frame: _Frame,
        camera: Optional[PinholeCamera] = ...,
        depth_scale: Optional[float] = ...,
        *,
        pose: Optional[ArrayLike] = ...,
        time: float = ...,
    ) -> TrackedFrame: ...
    @property
    def tracks(self) -> List[PlaneTrack]: ...
    def label_of(self, track: int) -> Optional[int]: ...
    @property
    def error_scale(self) -> float: ...

# Scan lines as they arrive

class StreamGeometry:
    @staticmethod
    def camera_columns(camera: PinholeCamera) -> StreamGeometry: ...
    @staticmethod
    def camera_rows(camera: PinholeCamera) -> StreamGeometry: ...
    @staticmethod
    def scanner(
        elevations: Sequence[float], azimuth_step: float, ring_azimuths: Optional[Sequence[float]] = ...
    ) -> StreamGeometry: ...
    @staticmethod
    def points(height: int, projection: _Projection, azimuth_step: float = ...) -> StreamGeometry: ...
    @property
    def kind(self) -> Literal["camera-columns", "camera-rows", "scanner", "points"]: ...
    @property
    def height(self) -> int: ...
    @property
    def elevations(self) -> List[float]: ...
    @property
    def azimuth_step(self) -> float: ...
    @property
    def ring_azimuths(self) -> List[float]: ...
    @property
    def is_staggered(self) -> bool: ...
    @property
    def projection(self) -> _Projection: ...
    def ring_shift(self, ring: int) -> int: ...

class StreamPlane:
    @property
    def id(self) -> int: ...
    @property
    def plane(self) -> Plane: ...
    @property
    def first_line(self) -> int: ...
    @property
    def last_line(self) -> int: ...
    @property
    def segments(self) -> int: ...
    @property
    def is_cut(self) -> bool: ...

class LabelledLine:
    @property
    def index(self) -> int: ...
    @property
    def azimuth(self) -> float: ...
    @property
    def runs(self) -> NDArray[numpy.int64]: ...
    @property
    def labels(self) -> NDArray[numpy.int64]: ...

class ScanLineStream:
    on_plane: Optional[Callable[[StreamPlane], Any]]
    on_line: Optional[Callable[[LabelledLine], Any]]
    def __init__(
        self,
        geometry: StreamGeometry,
        parameters: Optional[Parameters] = ...,
        sensor: _Sensor = ...,
        *,
        measured_lines: int = ...,
        lines_at_once: int = ...,
        longest_plane: int = ...,
        on_plane: Optional[Callable[[StreamPlane], Any]] = ...,
        on_line: Optional[Callable[[LabelledLine], Any]] = ...,
    ) -> None: ...
    def add_column(
        self, index: int, values: _Values, azimuth: Optional[float] = ..., *, depth_scale: Optional[float] = ...
    ) -> bool: ...
    def add_row(self, index: int, values: _Values, *, depth_scale: Optional[float] = ...) -> bool: ...
    def add_column_at(self, azimuth: float, values: _Values, *, depth_scale: Optional[float] = ...) -> bool: ...
    def add_points(self, index: int, points: NDArray[numpy.float32]) -> bool: ...
    def finish(self) -> None: ...
    def reset(self) -> None: ...
    def open_planes(self) -> List[StreamPlane]: ...
    @property
    def geometry(self) -> StreamGeometry: ...
    @property
    def taken(self) -> int: ...
    @property
    def lost(self) -> int: ...
    @property
    def refused(self) -> int: ...
    @property
    def sensor(self) -> SensorModel: ...
    @property
    def is_measuring(self) -> bool: ...
    @property
    def measured_blocks(self) -> int: ...

# The processor

def vector_units() -> List[str]: ...
def vector_unit() -> str: ...
def set_vector_unit(name: str) -> None: ...

# Parameters

class ParameterField:
    @property
    def name(self) -> str: ...
    @property
    def type(self) -> Literal["bool", "str", "int", "float"]: ...
    @property
    def default(self) -> Union[bool, str, int, float]: ...
    @property
    def range(self) -> str: ...
    @property
    def low(self) -> float: ...
    @property
    def high(self) -> float: ...
    @property
    def choices(self) -> List[str]: ...
    @property
    def unit(self) -> str: ...
    @property
    def doc(self) -> str: ...

def parameter_fields() -> List[ParameterField]: ...

# From here on as scripts/python_stubs.py writes it.

class Parameters:
    mode: Literal["inverse-depth", "paper"]
    """Form of the method. inverse-depth | paper, default inverse-depth. Choose paper to compare with the
    publication."""
    scan: Literal["columns", "rows", "both"]
    """Scan lines. columns | rows | both, default both. Choose one direction to save time; rows are an error for
    spherical scans, whose rows are cones."""
    threads: int
    """Threads; the result does not depend on them. [1, 256] threads, default 1. Raise it if cores are idle; lower it if
    other work needs them."""
    line_segments: bool
    """Report the line segments too (PlaneSegmentation::segments). False | True, default False. Choose on to draw them,
    or to build something else than planes on them."""
    inverse_depth: InverseDepthParameters
    paper: PaperParameters
    def __init__(self, **fields: Union[bool, str, int, float]) -> None: ...
    @staticmethod
    def for_paper() -> Parameters: ...
    def set(self, assignment: str) -> None: ...
    def as_dict(self) -> Dict[str, Union[bool, str, int, float]]: ...
    def validate(self) -> None: ...
    def copy(self) -> Parameters: ...
    def __copy__(self) -> Parameters: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Parameters: ...

class InverseDepthParameters:
    min_points: int
    """Planes with fewer pixels are rejected (S7); of a frame whose pixels are scattered their area counts, holes
    included. [1, 1e9] pixels, default 60. Raise it if small pieces of clutter are reported; lower it if small faces are
    missing and the sensor is good enough to see them."""
    min_confidence: float
    """Planes that are less likely surfaces than this are rejected (S9), see Plane::confidence. [0, 1], default 0.3.
    Raise it if ragged pieces of clutter are reported; lower it if frames, rails and other narrow planes are missing."""
    stride: int
    """Grid of the samples that the planes are found on, every so many rows and columns; the labels are those of all
    pixels. 0: by the longer side, one for every 320 pixels. [0, 8] pixels, default 0. Raise it if time matters more
    than small faces; lower it if faces of a few pixels matter more than time."""
    adapt_sensor: bool
    """Pull size and correlation length of a given sensor model to those of the error that the frames show, unless they
    agree within 20 % (S0). False | True, default True. Choose off if the model is known to be right, and for repeatable
    experiments with wrong ones."""
    line_k_max: float
    """Gate of a line segment (S1): a sample belongs to it within so many standard deviations of the sensor model. (0,
    100] sigma_w, default 1.5. Raise it if surfaces break into pieces although the sensor model is right; lower it if
    shallow creases and small steps are run over."""
    plane_k_max: float
    """Gate of a plane (S2): a line segment joins the plane if it agrees with it within so many standard deviations. (0,
    100] sigma, default 2.0. Raise it if planes break along the scan direction; lower it if neighbouring faces that
    differ by a few degrees join."""
    region_tolerance: float
    """Offset within which two large regions are one surface (c2 of S4). [0, 100] sigma, default 1.5. Raise it if large
    walls stay in pieces that lie a little apart (over-segmentation); lower it if doors, steps or panels join the wall
    behind them (under-segmentation)."""
    expert: InverseDepthExpert
    def __init__(self, parameters: Parameters) -> None: ...

class InverseDepthExpert:
    evidence: InverseDepthEvidence
    lines: InverseDepthLines
    merging: InverseDepthMerging
    planes: InverseDepthPlanes
    refinement: InverseDepthRefinement
    def __init__(self, parameters: Parameters) -> None: ...

class InverseDepthEvidence:
    min_samples: float
    """Planes with fewer are rejected, whatever their residuals. [0, 1e6] independent samples, default 2.0. Raise it if
    blotches of the error are reported as planes; lower it if small faces are missing."""
    max_chi2: float
    """Largest mean squared residual of a plane. (0, 1e6] sigma^2, default 4.0. Raise it if real surfaces are rejected
    because the sensor model is too narrow; lower it if curved and cluttered regions are reported."""
    min_evidence: float
    """Samples that a plane needs, times max(0.5, chi^2). [0, 1e6] independent samples, default 11.0. Raise it if pieces
    of clutter are reported; lower it if small faces are missing."""
    rough_evidence: float
    """The least that a plane rougher than the sensor, chi^2 > 1, needs. [0, 1e6] independent samples, default 20.0.
    Raise it if pieces of chairs and plants are reported; lower it if small rough faces are missing."""
    min_radius: float
    """Surfaces that bend with a smaller radius are not planes. [0, 1e6] m, default 0.4. Raise it if facets of columns
    and cushions are reported; lower it if slightly bent boards are missing."""
    bending_share: float
    """Share of the squared residuals that bending must explain before a region is rejected for it. [0, 1], default 0.6.
    Raise it if bent boards are missing; lower it if facets of curved things are reported."""
    bending_evidence: float
    """Reduction of the squared residuals, in sigma^2 per independent sample, that bending must be worth. [0, 1e6]
    independent samples, default 5.0. Raise it if planes are rejected for the bending of the sensor; lower it if facets
    of curved things are reported."""
    def __init__(self, parameters: Parameters) -> None: ...

class InverseDepthLines:
    min_samples: int
    """Rejected samples in a row that may start a new line segment. [3, 100] samples, default 6. Raise it if clutter
    starts too many short segments; lower it if faces a few pixels wide are missing."""
    max_gap_pixels: int
    """A line segment ends after more missing or rejected pixels than this. [0, 1000] pixels, default 5. Raise it if
    holes in the depth cut surfaces; lower it if segments jump over narrow objects and grooves."""
    def __init__(self, parameters: Parameters) -> None: ...

class InverseDepthMerging:
    fragment_tolerance: float
    """Tolerance for fragments (c1): the fewer samples a region has, the farther off it may lie. [0, 1e6] independent
    samples, default 60.0. Raise it if small fragments stay beside the surface that they belong to; lower it if small
    faces are swallowed by large ones."""
    max_step: float
    """Largest step along the common border, rms. (0, 1e6] sigma, default 6.0. Raise it if fragments with a poor border
    stay apart; lower it if fragments jump over real steps."""
    ragged_border: float
    """Contacts, in those of a square of the smaller region, above which a border counts as ragged and the offset
    tolerance grows in proportion. (0, 1e6] squares, default 1.5. Raise it if interleaved surfaces of different depth
    join; lower it if one surface split by noise stays in interleaved pieces."""
    max_ragged_gain: float
    """Largest factor by which a ragged border widens the offset tolerance. [1, 100], default 2.0. Raise it if one
    surface split by noise stays in interleaved pieces; lower it if interleaved surfaces of different depth join."""
    max_ragged_step: float
    """Largest step along a ragged border, rms, at which the tolerance still grows. [0, 1e6] sigma, default 1.75. Raise
    it if one surface split by noise stays in interleaved pieces; lower it if surfaces a small step apart join along a
    ragged border."""
    bridge_samples: float
    """Regions are neighbours across a hole of this width. [0, 1000] independent samples of a line, default 1.0. Raise
    it if blotchy holes keep the parts of a wall apart; lower it if parts that lie on both sides of a hole join
    wrongly."""
    min_bridge_pixels: int
    """Regions are neighbours across a hole of this width, whatever the sensor. [0, 1000] pixels, default 2. Raise it if
    drop-outs and dark spots keep the parts of a wall apart; lower it if parts that lie on both sides of a hole join
    wrongly."""
    min_contacts: int
    """Regions are neighbours if they face each other in so many places. [1, 1e6] pixels, default 3. Raise it if regions
    join through a few pixels; lower it if thin faces stay apart from their surface."""
    min_samples: float
    """Regions with fewer are dropped before the borders are refined. [0, 1e6] independent samples, default 3.0. Raise
    it if specks eat into the borders; lower it if fragments are lost that the second merge would have used."""
    max_occluder: float
    """Regions on both sides of something nearer may be one surface (S8) if it covers no more of a row or column than
    this share of what is seen of the two; 0 keeps them apart. [0, 100], default 0.4. Raise it if a wall behind a broad
    object should be one plane; lower it if separate surfaces at the same depth join behind an object."""
    def __init__(self, parameters: Parameters) -> None: ...

class InverseDepthPlanes:
    min_overlap_pixels: int
    """Neighbouring segments of a plane overlap by at least so many pixels, and by half of the shorter. [1, 1000]
    pixels, default 3. Raise it if planes leak through thin bridges; lower it if narrow slanted faces break up."""
    max_prediction: float
    """Largest prediction variance of plane and line that widens the gate. [0, 1e6] sigma_w^2, default 9.0. Raise it if
    young planes lose segments that belong to them; lower it if young planes take segments that do not belong to
    them."""
    min_points: int
    """Planes with fewer pixels never reach the merge (S3). [1, 1e6] pixels, default 40. Raise it if many specks slow
    the merge down; lower it if fragments that would have completed a surface are missing."""
    min_segments: int
    """Planes of fewer line segments never reach the merge (S3). [1, 1e6] segments, default 2. Raise it if single noisy
    scan lines become planes; lower it if surfaces one scan line wide matter."""
    def __init__(self, parameters: Parameters) -> None: ...

class InverseDepthRefinement:
    passes: int
    """Passes over the borders. [0, 1000] passes, default 12. Raise it if unlabelled margins remain along the edges;
    lower it if time matters more than the last pixels."""
    max_residual: float
    """An unlabelled pixel joins a region within this residual; a pixel farther behind or in front of the regions on
    both sides of it is a groove (S4) or an occluder (S8). (0, 100] sigma, default 3.0. Raise it if surfaces have
    unlabelled pixels; lower it if objects on a surface are taken into it."""
    flip_gain: float
    """A labelled pixel changes sides for a gain of this much. [0, 100] sigma, default 0.3. Raise it if borders flicker
    between two regions; lower it if borders stay where the scan lines left them."""
    crease_passes: int
    """Passes, of all, in which creases are decided by geometry. [0, 1000] passes, default 6. Raise it if creases are
    still frayed; lower it if spikes grow at the corners of boxes."""
    crease_vote_pixels: int
    """Distance from the border at which the kind of a crease, convex or concave, is voted. [1, 100] pixels, default 6.
    Raise it if borders are frayed wider than this; lower it if faces are narrower than twice this."""
    crease_min_votes: int
    """Fewest votes that decide the kind of a crease. [1, 1e6] votes, default 5. Raise it if creases are misjudged;
    lower it if short creases are not sharpened."""
    crease_agreement: float
    """Share of the votes that decides the kind of a crease; at 0.5 a tie counts as convex. [0.5, 1], default 0.7. Raise
    it if creases are misjudged; lower it if noisy creases are not sharpened."""
    crease_range: float
    """Largest residual and plane difference at which a crease decides. [0, 100] sigma, default 4.0. Raise it if creases
    of noisy faces stay frayed; lower it if pixels far from both faces change sides."""
    crease_slack: float
    """Residual that a crease may cost a pixel. [0, 100] sigma, default 1.5. Raise it if creases stay frayed; lower it
    if pixels land on the wrong face."""
    def __init__(self, parameters: Parameters) -> None: ...

class PaperParameters:
    line_k_max: float
    """k_max of Eq. 20: a sample belongs to the line segment if d^2 <= k_max^2 (sigma^2 + s^2). (0, 100] sigma, default
    2.0. Raise it if scan lines break into short segments; lower it if segments bend around edges."""
    plane_k_max: float
    """k_max of Eq. 23: a line segment belongs to the plane if its cost is below k_max^2. (0, 100] sigma, default 3.0.
    Raise it if surfaces are over-segmented; lower it if neighbouring faces join (under-segmentation)."""
    max_gap: float
    """d_1 of Eq. 27: gap between neighbouring segments of a plane, beyond the noise. [0, 100] m, default 0.15. Raise it
    if holes cut surfaces; lower it if separate objects at the same depth join."""
    min_segments: int
    """Planes with fewer line segments are dropped (min_c of Sec. 7.1: 15 segments are the 30 end points). [1, 1e6]
    segments, default 15. Raise it if clutter is reported; lower it if narrow surfaces are missing."""
    min_points: int
    """Planes with fewer pixels are dropped. [0, 1e9] pixels, default 0. Raise it if specks are reported; lower it if
    small surfaces are missing."""
    criterion: Literal["a", "b", "c", "d"]
    """Form of the criterion (Table 2). a | b | c | d, default a. Choose b if segments are short and noisy, c or d only
    to study what the noise model is worth."""
    endpoint_weight: Literal["printed", "exponential", "gaussian", "cauchy", "huber", "none"]
    """Weight of an end point in the covariance of its plane (Eq. 26). printed | exponential | gaussian | cauchy | huber
    | none, default printed. Choose exponential on real depth, whose error is correlated, for fewer strips; cauchy or
    huber for fewer still, at the cost of small surfaces; none only to study what the weight is worth."""
    expert: PaperExpert
    def __init__(self, parameters: Parameters) -> None: ...

class PaperExpert:
    lines: PaperLines
    planes: PaperPlanes
    def __init__(self, parameters: Parameters) -> None: ...

class PaperLines:
    fit_samples: int
    """l: samples that fit the candidate of a new segment. [2, 100] samples, default 3. Raise it if candidates are
    fitted to noise; lower it if short segments are missing."""
    validation_samples: int
    """l_v: later samples that must agree with the candidate; k_min = l + l_v. [1, 100] samples, default 5. Raise it if
    candidates start in clutter; lower it if short segments are missing."""
    buffer_samples: int
    """n_buf: rejected samples kept for a new segment, at least k_min (Fig. 12). [2, 1000] samples, default 16. Raise it
    if outliers push the start of a surface out of the buffer; lower it if time matters: every start in the buffer is
    tried."""
    projection_floor: float
    """Smallest share of sigma_z^2 that counts across a grazing line (floor of q^2 in Eq. 20). [0, 1], default 0.1.
    Raise it if floors and side walls break up; lower it if steps on floors and side walls are run over."""
    use_sensor_noise: bool
    """Use sigma_z in Eq. 20. False | True, default True. Choose off only to study what the noise model is worth (Fig.
    15)."""
    def __init__(self, parameters: Parameters) -> None: ...

class PaperPlanes:
    look_back: int
    """Scan lines to look back for a segment that has a plane. [1, 100] scan lines, default 4. Raise it if scan lines
    without a segment end surfaces; lower it if separate surfaces join across a gap."""
    pair_look_back: int
    """Scan lines to look back for a partner that starts a plane, at most look_back; older segments are outliers. [1,
    100] scan lines, default 2. Raise it if surfaces start late; lower it if clutter starts planes."""
    max_start_angle: float
    """Largest angle between the two segments that start a plane. (0, 90] degrees, default 20.0. Raise it if slanted
    surfaces start late; lower it if planes start on curved things."""
    def __init__(self, parameters: Parameters) -> None: ...
