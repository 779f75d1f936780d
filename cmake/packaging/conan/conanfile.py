"""bullet_buoyancy from this tree, for Conan 2, on the bullet3 and eigen of ConanCenter:

    conan create cmake/packaging/conan --build=missing [-o "&:double_precision=True"]
"""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir

required_conan_version = ">=2.0"


class BulletBuoyancyConan(ConanFile):
    name = "bullet_buoyancy"
    description = "Buoyancy for Bullet Physics"
    license = "Zlib"
    topics = ("bullet", "physics", "buoyancy", "water", "waves")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "double_precision": [True, False]}
    default_options = {"shared": False, "fPIC": True, "double_precision": False}
    implements = ["auto_shared_fpic"]

    @property
    def _tree(self):
        return os.path.join(self.recipe_folder, "..", "..", "..")

    def set_version(self):
        lists = load(self, os.path.join(self._tree, "CMakeLists.txt"))
        self.version = re.search(r"^ *VERSION ([0-9.]+)$", lists, re.MULTILINE).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "bullet_buoyancy/*", "cmake/*"):
            copy(self, pattern, self._tree, self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/[>=3.4 <6]", transitive_headers=True)
        self.requires("bullet3/[>=3.24 <4]", transitive_headers=True, transitive_libs=True,
                      options={"double_precision": self.options.double_precision})

    def validate(self):
        check_min_cppstd(self, 17)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BULLET_BUOYANCY_DOUBLE_PRECISION"] = bool(self.options.double_precision)
        toolchain.cache_variables["BULLET_BUOYANCY_BUILD_TESTS"] = False
        toolchain.cache_variables["BULLET_BUOYANCY_BUILD_DEMOS"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        # Conan writes these for its users, by what package_info says.
        for folder in ("lib/cmake", "lib/pkgconfig", "share"):
            rmdir(self, os.path.join(self.package_folder, folder))

    def package_info(self):
        suffix = "-float64" if self.options.double_precision else ""

        core = self.cpp_info.components["core"]
        core.set_property("cmake_target_name", "bullet_buoyancy::core")
        core.libs = ["bullet_buoyancy_core" + suffix]
        core.requires = ["eigen::eigen"]
        if self.settings.os in ("Linux", "FreeBSD"):
            core.system_libs = ["m"]

        action = self.cpp_info.components["action"]
        action.set_property("cmake_target_name", "bullet_buoyancy::bullet_buoyancy")
        action.set_property("pkg_config_name", "bullet_buoyancy" + suffix)
        action.libs = ["bullet_buoyancy" + suffix]
        action.defines = [f"BULLET_BUOYANCY_DOUBLE_PRECISION={int(bool(self.options.double_precision))}"]
        action.requires = ["core", "bullet3::bullet3"]
