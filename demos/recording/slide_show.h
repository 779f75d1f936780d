#pragma once

#include "recording/film.h"
#include "scenes/study_cases.h"

namespace bullet_buoyancy::recording {

/// A film of hulls that are put into one pose after the other: a slide a second.
class SlideShow {
public:
    /// Its water reaches so far (m) from the hull to each side.
    SlideShow(FilmDef def, double reach);

    /// Goes on with the first `count` of the cases, as long as the film lasts. The water's frame is z up.
    void show(const std::string& name, Look look, const std::shared_ptr<const Hull>& hull,
              const WaterField& water, const std::vector<scenes::StudyCase>& cases, int count);

    const Film& film() const { return m_film; }

private:
    Film m_film;
};

}  // namespace bullet_buoyancy::recording
