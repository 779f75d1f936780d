#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>

#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/hydrostatics/stiffness.h"
#include "support/compare_results.h"
#include "support/near.h"
#include "support/read_mesh_file.h"
#include "support/still_water.h"

/// Hulls of real ships and platforms against what WAMIT and NEMOH printed for them, and meshes that are bad
/// in ways found in the wild. They are not part of this project: an environment variable says where they are.

namespace bullet_buoyancy::test {
namespace {

constexpr const char* variable = "BULLET_BUOYANCY_REFERENCE_DATA";

class ReferenceData : public testing::Test {
protected:
    void SetUp() override {
        const char* folder = std::getenv(variable);
        if (folder) {
            m_folder = folder;
            ASSERT_TRUE(std::filesystem::is_directory(m_folder)) << variable << " is " << folder;
            return;
        }
        std::cerr << "\n*** NOT TESTED: no reference data. Set the environment variable " << variable
                  << " to its folder. ***\n\n";
        GTEST_SKIP() << "set " << variable << " to the folder of the reference data";
    }

    std::filesystem::path hullPath(const std::string& name) const { return m_folder / "hulls" / name; }
    std::filesystem::path messyPath(const std::string& name) const { return m_folder / "messy" / name; }

    /// The fields of a table's lines, without its comments and its heading.
    std::vector<std::vector<std::string>> readTable(const std::filesystem::path& name) const {
        std::ifstream file(m_folder / name);
        std::vector<std::vector<std::string>> rows;
        bool headed = false;
        for (std::string line; std::getline(file, line);) {
            if (line.empty() || line[0] == '#') continue;
            std::istringstream fields(line);
            std::vector<std::string> row;
            for (std::string field; std::getline(fields, field, ',');)
                row.push_back(field);
            if (headed) rows.push_back(row);
            headed = true;
        }
        return rows;
    }

private:
    std::filesystem::path m_folder;
};

bool startsWith(const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
}

/// A number as it was printed.
struct Printed {
    double value = 0;
    double lastPlace = 0;  ///< half a unit of its last digit

    /// Several estimates of one number, parted by slashes, count by their mean.
    explicit Printed(const std::string& text) {
        std::istringstream numbers(text);
        int count = 0;
        for (std::string number; std::getline(numbers, number, '/'); ++count) {
            std::size_t length = 0;
            value += std::stod(number, &length);
            const std::size_t exponent = std::min(number.find('e'), length), point = number.find('.');
            const double decimals = point < exponent ? double(exponent - point - 1) : 0;
            const double power = exponent < length ? std::stod(number.substr(exponent + 1)) : 0;
            lastPlace = 0.5 * std::pow(10.0, power - decimals);
        }
        value /= count;
    }
};

/// The height of the centre of mass, "(... zG=-0.72 ...)", about which a table gives a stiffness; 0 unless it
/// says so.
double heightOfCom(const std::string& quantity) {
    const std::size_t place = quantity.find("zG=");
    return place == std::string::npos ? 0 : std::stod(quantity.substr(place + 3));
}

/// A hull afloat in a published position: the mesh's z = 0 at the surface.
struct Afloat {
    std::shared_ptr<const Hull> hull;
    HydrostaticResult result;  ///< about a centre of mass on the z axis
    double draft = 0, heightOfCom = 0;

    Afloat(const TriangleMesh& mesh, double height) : heightOfCom(height) {
        TriangleMesh aboutCom = mesh;
        for (Vec3& vertex : aboutCom.vertices) {
            draft = std::max(draft, -vertex.z());
            vertex.z() -= heightOfCom;
        }
        hull = makeHull(aboutCom).hull;
        if (hull) result = inStillWater(*hull, atHeight(heightOfCom));
    }
};

struct Comparison {
    double ours, tolerance;
};

/// Volume, centre and waterplane agree to 1e-4, the centre of the draft; rotational stiffness only to 0.5 %,
/// for the panel codes integrate it by the panels' centroids. Nothing for quantities of something else than
/// the mesh.
std::optional<Comparison> compare(const std::string& quantity, double published, const Afloat& ship) {
    const HydrostaticResult& result = ship.result;
    if (quantity == "volume") return Comparison{result.submergedVolume, 1e-4 * published};
    if (quantity == "zB")
        return Comparison{result.centreOfBuoyancyFromCom.z() + ship.heightOfCom, 1e-4 * ship.draft};
    if (quantity == "Awp" || quantity == "C33/(rho g)=Awp")
        return Comparison{result.waterplane.area, 1e-4 * published};
    const Mat6 stiffness = hydrostaticStiffness(result, Vec3::UnitZ(), 1);
    if (startsWith(quantity, "C44/") || startsWith(quantity, "K44/"))
        return Comparison{stiffness(3, 3), 5e-3 * std::abs(published)};
    if (startsWith(quantity, "C55/") || startsWith(quantity, "K55/"))
        return Comparison{stiffness(4, 4), 5e-3 * std::abs(published)};
    return std::nullopt;
}

using ReferenceHulls = ReferenceData;

TEST_F(ReferenceHulls, HaveThePublishedHydrostatics) {
    int compared = 0;
    for (const std::vector<std::string>& row : readTable("tables/published_hydrostatics.csv")) {
        if (row.size() < 4 || row[3].empty() || !std::filesystem::exists(hullPath(row[0]))) continue;
        SCOPED_TRACE(row[0] + ": " + row[2]);
        const Afloat ship(readMeshFile(hullPath(row[0])), heightOfCom(row[2]));
        ASSERT_TRUE(ship.hull);
        const Printed published(row[3]);
        const auto comparison = compare(row[2], published.value, ship);
        if (!comparison) continue;
        EXPECT_NEAR(comparison->ours, published.value, comparison->tolerance + published.lastPlace);
        ++compared;
    }
    EXPECT_GE(compared, 26) << "volume, centre, waterplane and stiffness of seven hulls";
}

TEST_F(ReferenceHulls, AreClosedAndNeedNoRepair) {
    int hulls = 0;
    for (const auto& entry : std::filesystem::directory_iterator(hullPath(""))) {
        SCOPED_TRACE(entry.path().filename());
        const HullResult made = makeHull(readMeshFile(entry.path()));
        ASSERT_TRUE(made.hull) << made.status.describe();
        EXPECT_EQ(made.status.openEdges, 0u);
        EXPECT_EQ(made.status.flippedTriangles, 0u);
        ++hulls;
    }
    EXPECT_GE(hulls, 8);
}

TEST_F(ReferenceHulls, AreEvaluatedAlikeFromBothSidesOfGauss) {
    Random random(1);
    for (const auto& entry : std::filesystem::directory_iterator(hullPath(""))) {
        SCOPED_TRACE(entry.path().filename());
        const auto hull = makeHull(readMeshFile(entry.path())).hull;
        ASSERT_TRUE(hull);
        for (int i = 0; i < 30; ++i) {
            const Pose pose = atSurface(*hull, random);
            const HydrostaticResult exact = inStillWater(*hull, pose);
            const HydrostaticResult reference = evaluateReference(*hull, pose, stillWater(), everything());
            // Ten thousand triangles, a hundred roundings each, of hulls that fill a thousandth of their
            // sphere.
            EXPECT_LT(relativeDifference(exact, reference, *hull, weightDensity), 1e-9);
            EXPECT_LT(relativeAreaDifference(exact, reference, *hull), 1e-9);
        }
    }
}

/// What is known of a bad mesh.
struct Audit {
    std::string file;
    std::size_t boundaryEdges, nonManifoldEdges, inconsistentEdges;
    std::optional<Printed> volume;

    explicit Audit(const std::vector<std::string>& row)
        : file(row.at(0)),
          boundaryEdges(std::stoul(row.at(4))),
          nonManifoldEdges(std::stoul(row.at(5))),
          inconsistentEdges(std::stoul(row.at(6))) {
        if (std::isdigit(row.at(11)[0])) volume = Printed(row[11]);
    }

    bool isSheet() const { return volume && volume->value == 0; }
    bool isClosed() const { return boundaryEdges == 0 && inconsistentEdges == 0; }
};

bool isFinite(const HydrostaticResult& result) {
    return result.forceWorld.allFinite() && result.torqueAboutCom.allFinite() &&
           result.centreOfBuoyancyFromCom.allFinite() && std::isfinite(result.potentialEnergy) &&
           std::isfinite(result.wettedArea) && result.waterplane.secondMoment.allFinite();
}

using MessyMeshes = ReferenceData;

TEST_F(MessyMeshes, AreTakenOrRefusedAsTheirAuditTells) {
    int meshes = 0;
    for (const std::vector<std::string>& row : readTable("messy/AUDIT.csv")) {
        const Audit audit(row);
        SCOPED_TRACE(audit.file);
        const TriangleMesh mesh = readMeshFile(messyPath(audit.file));
        ASSERT_FALSE(mesh.triangles.empty());
        ++meshes;
        const HullResult made = makeHull(mesh);
        const HullStatus& status = made.status;
        if (audit.isSheet()) {
            EXPECT_EQ(status.error, HullError::noVolume);
            continue;
        }
        ASSERT_TRUE(made.hull) << status.describe();
        if (audit.isClosed()) {
            EXPECT_EQ(status.openEdges, 0u);
            EXPECT_EQ(status.flippedTriangles, 0u);
            EXPECT_NEAR(made.hull->moments.volume, audit.volume->value, audit.volume->lastPlace);
        } else {
            // Where triangles disagree in their winding, turning them may close edges, never a boundary.
            EXPECT_GE(status.openEdges, audit.boundaryEdges);
            if (audit.nonManifoldEdges == 0 && audit.inconsistentEdges == 0) {
                EXPECT_EQ(status.openEdges, audit.boundaryEdges);
            }
        }
    }
    EXPECT_GE(meshes, 13);
}

TEST_F(MessyMeshes, GiveFiniteResultsEverywhere) {
    Random random(2);
    for (const std::vector<std::string>& row : readTable("messy/AUDIT.csv")) {
        SCOPED_TRACE(row.at(0));
        const auto hull = makeHull(readMeshFile(messyPath(row.at(0)))).hull;
        if (!hull) continue;
        for (int i = 0; i < 30; ++i) {
            const Pose pose = atSurface(*hull, random);
            EXPECT_TRUE(isFinite(inStillWater(*hull, pose)));
        }
    }
}

TEST_F(MessyMeshes, SurviveBeingTurnedInsideOut) {
    for (const std::vector<std::string>& row : readTable("messy/AUDIT.csv")) {
        const Audit audit(row);
        if (!audit.isClosed() || audit.isSheet()) continue;
        SCOPED_TRACE(audit.file);
        TriangleMesh mesh = readMeshFile(messyPath(audit.file));
        for (Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
        const HullResult made = makeHull(mesh);
        ASSERT_TRUE(made.hull) << made.status.describe();
        EXPECT_EQ(made.status.openEdges, 0u);
        EXPECT_NEAR(made.hull->moments.volume, audit.volume->value, audit.volume->lastPlace);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
