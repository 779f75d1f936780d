#include "bullet_buoyancy/water/water_status.h"

#include <sstream>

namespace bullet_buoyancy {

std::string WaterStatus::describe() const {
    switch (error) {
        case WaterError::none:
            return "ok";
        case WaterError::notFinite:
            return "a number that describes the water is not finite";
        case WaterError::badDepth:
            return "the depth of the water and gravity must be above zero";
        case WaterError::badComponent:
            return "a wave component has a negative amplitude, or a wavenumber that is not above zero";
        case WaterError::loopedCrest: {
            std::ostringstream text;
            text << "the crests would loop: amplitudes times wavenumbers add up to a steepness of "
                 << steepness << ", which must be below 1";
            return text.str();
        }
        case WaterError::badSpectrum:
            return "the sea state's height, period, peakedness, spreading, frequency range or number of "
                   "components is out of range";
        case WaterError::badGrid:
            return "a height grid needs two nodes along each axis and a spacing above zero";
        case WaterError::badProfile:
            return "the exponent of a current's profile must not be negative";
    }
    return "unknown error";
}

}  // namespace bullet_buoyancy
