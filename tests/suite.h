#pragma once

#include <QObject>

#include <memory>

/// Names the suite of a file: `SUITE(tst_walls, TestWalls)` at the end of `tst_walls.cpp`. One program per folder has all
/// its suites; a table that CMake writes from the names of the files calls the function that this defines.
#define SUITE(name, Class)                                                                                   \
    std::unique_ptr<QObject> name()                                                                          \
    {                                                                                                        \
        return std::make_unique<Class>();                                                                    \
    }

/// The same for a suite that makes and ends applications itself.
#define SUITE_WITHOUT_APPLICATION(name, Class) SUITE(name, Class)
