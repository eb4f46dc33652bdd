#include "tests/suites.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <cstring>

namespace tests {

int runSuite(std::span<const Suite> suites, MakeApplication makeApplication, int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "";
    for (const Suite &suite : suites) {
        if (std::strcmp(suite.name, name) != 0)
            continue;
        const QTemporaryDir folder; // in place of the settings and files of the person who runs the tests
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
        qputenv("XDG_DATA_HOME", folder.filePath(QStringLiteral("data")).toLocal8Bit());
        QCoreApplication::setOrganizationName(QStringLiteral("springstep-tests"));
        QCoreApplication::setApplicationName(QLatin1String(name));
        argv[1] = argv[0]; // Qt Test reads its arguments after the name of the program
        const auto application = suite.needsApplication ? makeApplication(argc, argv) : nullptr;
        return QTest::qExec(suite.make().get(), argc - 1, argv + 1);
    }
    std::fprintf(stderr, "%s SUITE [ARGUMENTS OF QT TEST]. The suites:\n", argv[0]);
    for (const Suite &suite : suites)
        std::fprintf(stderr, "  %s\n", suite.name);
    return 2;
}

}
