// Writes the seeds of the fuzzers' corpora, cases to search from, into a folder:
//
//   write_fuzz_seeds tests/fuzz/corpus

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/choices.h"
#include "fuzz/input.h"
#include "fuzz/read_mesh.h"
#include "fuzz/state_bytes.h"

namespace bullet_buoyancy::fuzz {
namespace {

/// What an `Input` reads.
class Output {
public:
    Output& byte(int value) {
        m_bytes.push_back(char(value));
        return *this;
    }

    template <typename T>
    Output& bits(T value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        m_bytes.append(bytes, sizeof value);
        return *this;
    }

    Output& number(double value) {
        const double place = value * 32 + middleOfGrid;
        if (place == std::floor(place) && place >= 0 && place <= int(lastOfGrid)) return byte(int(place));
        return byte(aDouble).bits(value);
    }

    Output& vector(double x, double y, double z) { return number(x).number(y).number(z); }

    Output& unit(double value) { return bits(std::uint16_t(std::lround((value + 1) * 32767.5))); }

    Output& inCube(double x, double y, double z) { return unit(x).unit(y).unit(z); }

    Output& text(const std::string& words) {
        m_bytes += words;
        return *this;
    }

    const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

class Corpus {
public:
    explicit Corpus(std::filesystem::path folder) : m_folder(std::move(folder)) {
        std::filesystem::create_directories(m_folder);
    }

    void write(const std::string& name, const Output& output) const {
        std::ofstream(m_folder / ("seed_" + name), std::ios::binary) << output.bytes();
    }

private:
    std::filesystem::path m_folder;
};

Output meshOf(MeshStart start, int edits) {
    return Output().byte(start).byte(edits);
}

void writeHulls(const Corpus& corpus) {
    corpus.write("box", meshOf(aBox, 0));
    corpus.write("soup_of_a_ball", meshOf(aBall, 1).byte(breakUp));
    corpus.write("inside_out", meshOf(aRing, 0).byte(5));
    corpus.write("two_boxes_and_a_cavity", meshOf(aBox, 3)
                                               .byte(addBox)
                                               .vector(1, 1, 1)
                                               .vector(3, 0, 0)
                                               .byte(addBox)
                                               .vector(0.5, 0.5, 0.5)
                                               .vector(0, 0, 0)
                                               .byte(turnAll));
    corpus.write("open_and_repeated", meshOf(aBox, 4)
                                          .byte(removeTriangle)
                                          .bits(std::uint16_t(3))
                                          .byte(repeatTriangle)
                                          .bits(std::uint16_t(1))
                                          .byte(turnTriangle)
                                          .bits(std::uint16_t(5))
                                          .byte(splitVertex)
                                          .bits(std::uint16_t(2))
                                          .byte(1));
    corpus.write("tetrahedron", meshOf(nothing, 8)
                                    .byte(addVertex)
                                    .vector(0, 0, 0)
                                    .byte(addVertex)
                                    .vector(1, 0, 0)
                                    .byte(addVertex)
                                    .vector(0, 1, 0)
                                    .byte(addVertex)
                                    .vector(0, 0, 1)
                                    .byte(addTriangle)
                                    .text(std::string("\0\0\2\0\1\0", 6))
                                    .byte(addTriangle)
                                    .text(std::string("\0\0\1\0\3\0", 6))
                                    .byte(addTriangle)
                                    .text(std::string("\1\0\2\0\3\0", 6))
                                    .byte(addTriangle)
                                    .text(std::string("\0\0\3\0\2\0", 6)));
    corpus.write("enormous", meshOf(aBall, 1).byte(scaleAll).vector(1e30, 1e30, 1e30));
    corpus.write("minute", meshOf(aBox, 1).byte(scaleAll).vector(1e-30, 1e-30, 1e-30));
    corpus.write("flat", meshOf(aBox, 1).byte(scaleAll).vector(1, 1, 0));
    corpus.write("stray", meshOf(aBox, 1).byte(strayIndex).bits(std::uint16_t(4)).byte(1).bits(99u));
}

Output partIn(EvaluatedPart part) {
    return Output().byte(0).byte(part);
}

/// How a hull lies, and in which water.
Output& afloat(Output& output, EvaluatedWater water) {
    output.inCube(0.3, 0.2, 0.1).unit(0.8).inCube(0, 0, 0);                // of the part
    output.byte(7).unit(0).inCube(0.1, 0.5, 0).unit(1).inCube(0, 0, 0.1);  // query and pose
    output.byte(water);
    output.inCube(0, 0, 1).inCube(0, 0, 0);  // the water's frame
    if (water == stillWater) return output.unit(0);
    output.byte(1).unit(0.2).unit(0).unit(0).unit(-0.4).unit(0.5).unit(0.3);  // two waves
    return output.byte(1).unit(0);
}

void writeEvaluated(const Corpus& corpus) {
    Output box = partIn(boxPart).unit(0.4).unit(0.1).unit(0);
    corpus.write("box", afloat(box, stillWater));
    Output ball = partIn(bumpyPart).byte(1).unit(0).unit(0.2).unit(0.1).inCube(0.5, 0.7, 0.1);
    corpus.write("ball_in_waves", afloat(ball, airyWater));
    Output ring = partIn(ringPart).unit(0).unit(0).unit(-0.2).byte(8);
    corpus.write("ring_in_trochoids", afloat(ring, gerstnerWater));
    Output cylinder = partIn(cylinderPart).unit(0).unit(0.2).unit(0);
    corpus.write("cylinder_in_waves", afloat(cylinder, airyWater));
    Output sphere = partIn(spherePart).unit(0.2);
    corpus.write("sphere", afloat(sphere, stillWater));
    Output capsule = partIn(capsulePart).unit(0).unit(-0.2).unit(0.1);
    corpus.write("capsule", afloat(capsule, stillWater));
    Output cloud = partIn(cloudPart).unit(0).unit(0).unit(0).byte(2);
    for (int i = 0; i < 6; ++i)
        cloud.inCube(std::cos(i), std::sin(2 * i), std::cos(5 * i));
    corpus.write("cloud", afloat(cloud, stillWater));
}

void writeShapes(const Corpus& corpus) {
    const auto shape = [](ShapeKind kind) { return Output().byte(kind); };
    corpus.write("box", shape(boxShape).vector(0.5, 1, 1.5).byte(0));
    corpus.write("scaled_box", shape(boxShape).vector(0.5, 1, 1.5).byte(3).number(0.125).vector(2, 1, -1));
    corpus.write("sphere", shape(sphereShape).number(1).byte(0));
    corpus.write("capsule", shape(capsuleShape).number(0.5).number(2).byte(2).byte(0));
    corpus.write("cylinder", shape(cylinderShape).vector(0.5, 0.5, 2).byte(2).byte(0));
    corpus.write("cone", shape(coneShape).number(0.5).number(2).byte(1).byte(0));
    corpus.write(
        "spheres",
        shape(multiSphereShape).byte(1).vector(0, 0, 0).number(1).vector(1, 0, 0).number(0.5).byte(0));
    Output points = shape(convexHullShape).byte(8);
    for (int i = 0; i < 8; ++i)
        points.vector(i & 1, (i >> 1) & 1, i >> 2);
    corpus.write("points", points.byte(0));
    corpus.write("tetrahedron",
                 shape(tetrahedronShape).vector(0, 0, 0).vector(1, 0, 0).vector(0, 1, 0).vector(0, 0, 1));
    const auto boxMesh = [](Output output, int indexType, int vertexType) {
        return output.byte(1).byte(aBox).byte(0).byte(indexType).byte(vertexType).byte(1).byte(1).byte(0);
    };
    corpus.write("mesh", boxMesh(shape(bvhMeshShape), 0, 1));
    corpus.write("mesh_of_shorts", boxMesh(shape(convexMeshShape), 1, 0));
    corpus.write("mesh_of_bytes", boxMesh(shape(gimpactMeshShape), 2, 1));
    corpus.write("scaled_mesh", boxMesh(shape(scaledMeshShape), 0, 0).vector(1, 2, 3));
    corpus.write("compound", shape(compoundShape)
                                 .byte(2)
                                 .byte(boxShape)
                                 .vector(0.5, 1, 1.5)
                                 .byte(0)
                                 .byte(sphereShape)
                                 .number(1)
                                 .byte(0)
                                 .inCube(0, 0, 0)
                                 .inCube(1, 0, 0)
                                 .unit(0)
                                 .inCube(0, 0, 0)
                                 .inCube(-1, 0, 0)
                                 .unit(0));
    corpus.write("sum", shape(minkowskiShape).byte(sphereShape).number(1).byte(0).vector(0.5, 0.5, 0.5));
    corpus.write("scaled_sphere", shape(uniformScalingShape).byte(sphereShape).number(1).byte(0).number(2));
    corpus.write("plane", shape(planeShape).vector(0, 0, 1).number(0));
}

void writeStates(const Corpus& corpus) {
    const auto changed = [](int signs) { return Output().byte(changedState).byte(signs); };
    corpus.write("same", changed(1));
    corpus.write("unsigned", changed(0).byte(setSmall).bits(std::uint16_t(20)).byte(1));
    corpus.write("number", changed(1).byte(setNumber).bits(std::uint16_t(40)).number(0.5));
    corpus.write("short", changed(1).byte(cutShort).bits(std::uint16_t(0)).bits(std::uint16_t(400)));
    corpus.write("mark", Output().byte(rawState).text("BuoyStat"));
}

void writeMeshFiles(const Corpus& corpus) {
    const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
                      faces[] = {"0 2 1", "0 1 3", "1 2 3", "0 3 2"};
    std::string ofOff = "OFF\n4 4 6\n" + corners, ofPly, ofObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    for (const std::string& face : faces) {
        ofOff += "3 " + face + "\n";
        ofPly += "3 " + face + "\n";
    }
    ofObj += "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    corpus.write("obj", Output().byte(0).text(ofObj));
    corpus.write(
        "stl", Output().byte(1).text("solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n"
                                     "vertex 1 0 0\nendloop\nendfacet\nendsolid t\n"));
    corpus.write("ply",
                 Output().byte(2).text("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
                                       "float y\nproperty float z\nelement face 4\nproperty list uchar int "
                                       "vertex_indices\nend_header\n" +
                                       corners + ofPly));
    corpus.write("off", Output().byte(3).text(ofOff));
}

}  // namespace
}  // namespace bullet_buoyancy::fuzz

int main(int argc, char** argv) {
    using namespace bullet_buoyancy::fuzz;
    if (argc != 2) return 1;
    const std::filesystem::path folder = argv[1];
    writeHulls(Corpus(folder / "hull"));
    writeEvaluated(Corpus(folder / "evaluators"));
    writeShapes(Corpus(folder / "shapes"));
    writeStates(Corpus(folder / "state"));
    writeMeshFiles(Corpus(folder / "mesh_files"));
    return 0;
}
