#pragma once

#include <QCoreApplication>

#include <memory>
#include <span>

namespace tests {

/// A suite of this program, by the name of its file.
struct Suite
{
    const char *name;
    std::unique_ptr<QObject> (*make)();
    bool needsApplication;
};

/// Makes the application that the suites of this program run in.
using MakeApplication = std::unique_ptr<QCoreApplication> (*)(int &argc, char **argv);

/// Runs the suite that the first argument names, with the rest as arguments of Qt Test. Without a name, or with an
/// unknown one, lists the suites. Returns the exit code.
int runSuite(std::span<const Suite> suites, MakeApplication makeApplication, int argc, char **argv);

}
