"""Every rule of the architecture must be able to fail."""

import tempfile
import unittest
from pathlib import Path

import rules


class Rules(unittest.TestCase):
    def breaches(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.parent.mkdir(parents=True)
            path.write_text(text, encoding="utf-8")
            return list(rules.breaches(Path(folder)))

    def assert_breach(self, name, text, line=1):
        found = self.breaches(name, text)
        self.assertEqual(len(found), 1, f"{text!r} in {name}: {found}")
        self.assertTrue(found[0].startswith(f"{name}:{line}: "), found[0])

    def assert_clean(self, name, text):
        self.assertEqual(self.breaches(name, text), [])

    def test_engine_includes_only_what_it_may(self):
        for header in ["httplib.h", "sqlite3.h", "SQLiteCpp/SQLiteCpp.h", "hdf5.h", "H5Cpp.h", "spdlog/spdlog.h",
                       "storage/jobs/job_store.h", "service/log.h", "unistd.h", "math.h"]:
            self.assert_breach("engine/plan/plan.cpp", f"#include <{header}>\n")
        for header in ["vector", "string_view", "Eigen/Dense", "nlohmann/json.hpp", "engine/case/case.h"]:
            self.assert_clean("engine/plan/plan.cpp", f"#include <{header}>\n")

    def test_inner_arrows_point_one_way(self):
        for here, there in [("case", "error"), ("case", "plan"), ("geometry", "particles"), ("operators", "linear"),
                            ("cells", "effects"), ("effects", "plan"), ("effects", "simulation"),
                            ("observe", "plan"), ("plan", "simulation"), ("observe", "simulation"),
                            ("case", "unheard_of"), ("unheard_of", "case")]:
            self.assert_breach(f"engine/{here}/a.h", f'#pragma once\n#include "engine/{there}/b.h"\n', line=2)
        for here, there in [("simulation", "observe"), ("plan", "observe"), ("effects", "cells"), ("cells", "cells"),
                            ("effects", "error"), ("plan", "effects")]:
            self.assert_clean(f"engine/{here}/a.h", f'#include "engine/{there}/b.h"\n')

    def test_engine_neither_prints_nor_ends_the_process(self):
        for code in ["std::cout << 1;", "std::cerr << 1;", 'printf("%d", 1);', 'std::fprintf(stderr, "x");',
                     "exit(1);", "std::abort();", "std::terminate();", "std::quick_exit(0);", 'puts("x");']:
            self.assert_breach("engine/plan/plan.cpp", f"void f() {{\n  {code}\n}}\n", line=2)
        for code in ["// exit(1)", "/* abort( \n printf( */", "log_.exit(1);", "on_exit(1);", 'x = "exit(1)";',
                     "std::snprintf(b, 3, f);"]:
            self.assert_clean("engine/plan/plan.cpp", f"{code}\n")

    def test_storage_does_not_know_the_service(self):
        self.assert_breach("storage/jobs/a.cpp", '#include "service/log.h"\n')
        self.assert_clean("storage/jobs/a.cpp", '#include "engine/case/case.h"\n#include <hdf5.h>\n')

    def test_fast_math_is_nowhere(self):
        self.assert_breach("cmake/flags.cmake", "add_compile_options(-ffast-math)\n")
        self.assert_breach("engine/CMakeLists.txt", "add_compile_options(-Ofast)\n")
        self.assert_breach("engine/linear/a.h", '#pragma GCC optimize("fast-math")\n')
        self.assert_clean("cmake/flags.cmake", "# -ffast-math is nowhere\n")


if __name__ == "__main__":
    unittest.main()
