#pragma once

namespace bullet_buoyancy {

/// Half a turn, rad.
inline constexpr double pi = 3.14159265358979323846;

/// Density of fresh water at 4 degrees Celsius, kg/m^3.
inline constexpr double freshWaterDensity = 1000.0;

/// Density of standard sea water (salinity 35 g/kg, 15 degrees Celsius), kg/m^3.
inline constexpr double seaWaterDensity = 1026.0;

/// Standard acceleration of gravity (ISO 80000-3), m/s^2.
inline constexpr double standardGravity = 9.80665;

/// Vertices closer than this times the mesh's size are one vertex. Meshes that have been through single
/// precision (STL, GPU buffers) repeat a vertex with an error of 6e-8 of its coordinates.
inline constexpr double weldTolerance = 1e-7;

/// A mesh whose volume is below this times the cube of its size is a sheet: it displaces nothing but
/// rounding.
inline constexpr double flatnessTolerance = 1e-12;

/// Points nearer to a face than this times the cloud's size lie on it. Rounding of a plane equation in double
/// precision is a few 1e-16 of the size; collision shapes in single precision round their points by 6e-8 of
/// it, and a point that is left out by this tolerance changes the volume by no more than this tolerance.
inline constexpr double convexHullTolerance = 1e-10;

/// Overlap of two parts of a hull is reported from this fraction of the smaller part's volume on: what faces
/// that were meant to touch may share by rounding in single precision.
inline constexpr double overlapTolerance = 1e-5;

}  // namespace bullet_buoyancy
