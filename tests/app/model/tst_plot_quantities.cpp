// Quantities of a run against closed forms and published trajectories, and their saved tables.

#include "app/model/experiment/experiment.h"
#include "app/model/series/number_table.h"
#include "app/model/text/quantity_text.h"
#include "tests/app/model/plots_support.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace app;
using namespace plots_support;

namespace {

/// Rows of some quantities of a run, from its start.
std::vector<std::vector<double>> rowsOf(const sim::Script &script, const std::vector<Quantity> &quantities,
                                        std::int64_t frames)
{
    sim::Track track(script, std::size_t{1} << 20);
    track.seek({frames, 0});
    RunSampler sampler(quantities, 0, track.framesPerOutput(), 1);
    while (sampler.samples().nextFrame() <= frames)
        sampler.readNext(track);
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < sampler.samples().size(); ++i) {
        rows.emplace_back();
        for (std::size_t column = 0; column < quantities.size(); ++column)
            rows.back().push_back(sampler.samples().at(i, column).first);
    }
    return rows;
}

sim::Script scriptOf(const char *step)
{
    return library().lessons.front().step(step)->script();
}

Quantity of(QuantityKind what, const QString &body = "foot")
{
    return {what, aboutOf(what) == About::run ? QString() : body};
}

NumberSheet sheetOf(const char *step, std::int64_t frames)
{
    NumberSheet sheet;
    sheet.quantities = {of(QuantityKind::placeY), of(QuantityKind::accelerationY)};
    sheet.titles = QStringList{"y [px]", "a, \"down\""};
    sheet.run = scriptOf(step);
    sheet.frames = frames;
    return sheet;
}

}

class PlotQuantities : public QObject
{
    Q_OBJECT

private slots:
    void aNameIsReadBack()
    {
        for (const QuantityKind what : quantityKinds()) {
            Quantity quantity = of(what);
            if (aboutOf(what) == About::twoBodies)
                quantity.other = "body";
            QCOMPARE(quantityFrom(quantityName(quantity)), std::optional(quantity));
        }
        QCOMPARE(quantityFrom(" distance( foot ,body ) "),
                 std::optional(Quantity{QuantityKind::distance, "foot", "body"}));
        QCOMPARE(quantityFrom("y"), std::optional(Quantity{QuantityKind::placeY}));
        for (const char *name :
             {"", "z(foot)", "y(foot", "y()", "y(foot, body)", "energy(foot)", "distance(foot)", "y(foot) x"})
            QVERIFY2(!quantityFrom(name), name);
    }

    /// Semi-implicit Euler with h = 1: v = g n, y = y0 + g n (n + 1) / 2.
    void aFreeFallIsTheMethodsParabola()
    {
        const std::vector<Quantity> all = {of(QuantityKind::placeY),       of(QuantityKind::velocityY),
                                           of(QuantityKind::speed),        of(QuantityKind::accelerationY),
                                           of(QuantityKind::acceleration), of(QuantityKind::time),
                                           of(QuantityKind::placeX),       of(QuantityKind::velocityX)};
        const auto rows = rowsOf(scriptOf("fall"), all, 300);
        QCOMPARE(rows.size(), 301);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto n = static_cast<double>(i);
            QVERIFY(std::abs(rows[i][0] - (fallFrom + gravity * n * (n + 1.0) / 2.0)) < 1e-9);
            QVERIFY(std::abs(rows[i][1] - gravity * n) < 1e-10);
            QVERIFY(std::abs(rows[i][2] - gravity * n) < 1e-10);
            if (i > 0) {
                QVERIFY(std::abs(rows[i][3] - gravity) < 1e-10);
                QVERIFY(std::abs(rows[i][4] - gravity) < 1e-10);
            }
            QCOMPARE(rows[i][5], n);
            QCOMPARE(rows[i][6], 100.0);
            QCOMPARE(rows[i][7], 0.0);
        }
        QVERIFY(std::isnan(rows[0][3])); // nothing was before
    }

    /// The implicit midpoint rule keeps quadratic energies; k d^2 / 2 and v^2 / 2 are written out here.
    void anUndampedSpringKeepsItsEnergy()
    {
        const std::vector<Quantity> all = {of(QuantityKind::energy),    of(QuantityKind::motion),
                                           of(QuantityKind::stored),    of(QuantityKind::placeY),
                                           of(QuantityKind::velocityY), of(QuantityKind::ownMotion)};
        const auto rows = rowsOf(scriptOf("swing"), all, 500);
        const double whole = 0.5 * stiffness * pulledBy * pulledBy;
        double fastest = 0.0;
        for (const std::vector<double> &row : rows) {
            const double d = row[3] - 200.0, v = row[4];
            QVERIFY(std::abs(row[0] - whole) < 1e-9 * whole);
            QVERIFY(std::abs(row[1] - 0.5 * v * v) < 1e-12);
            QVERIFY(std::abs(row[2] - 0.5 * stiffness * d * d) < 1e-10);
            QCOMPARE(row[5], row[1]); // there is nothing else that moves
            fastest = std::max(fastest, row[1]);
        }
        QVERIFY(fastest > 0.99 * whole);
    }

    void positionsAndVelocitiesMatchThePublishedOnes_data()
    {
        QTest::addColumn<QString>("path");
        for (const QFileInfo &info : QDir(TEST_DATA "/published").entryInfoList({"*.json"}))
            QTest::newRow(qPrintable(info.completeBaseName())) << info.absoluteFilePath();
    }

    void positionsAndVelocitiesMatchThePublishedOnes()
    {
        QFETCH(QString, path);
        static const LessonLibrary lessons = LessonLibrary::load(LessonLibrary::folders());
        const Experiment experiment = readExperiment(path, lessons);
        const QStringList lines =
            QString::fromUtf8(tests::contentsOf(path.chopped(5) + ".csv")).trimmed().split('\n');
        const QStringList titles = lines.first().trimmed().split(',');
        const std::map<QString, QuantityKind> columns = {{"x", QuantityKind::placeX},
                                                         {"y", QuantityKind::placeY},
                                                         {"vx", QuantityKind::velocityX},
                                                         {"vy", QuantityKind::velocityY},
                                                         {"angle", QuantityKind::angle}};
        std::vector<Quantity> quantities;
        std::map<QString, std::size_t> first; // column of a body's first quantity
        sim::Track start(experiment.script, 0);
        const sim::Scene &scene = start.interval().scene;
        for (const std::string &name : scene.names) {
            first[QString::fromStdString(name)] = quantities.size();
            for (const QString &title : titles.mid(2))
                quantities.push_back({columns.at(title), QString::fromStdString(name)});
        }
        const std::int64_t frames = lines.last().section(',', 0, 0).toLongLong();
        const auto rows = rowsOf(experiment.script, quantities, frames);
        for (const QString &line : lines.mid(1)) {
            const QStringList fields = line.trimmed().split(',');
            const std::vector<double> &row = rows[fields[0].toULongLong()];
            for (qsizetype i = 2; i < fields.size(); ++i) {
                const double is = row[first.at(fields[1]) + static_cast<std::size_t>(i) - 2];
                if (titles[i].startsWith('v') &&
                    !scene.movesByVelocity(scene.find(fields[1].toStdString()))) {
                    QCOMPARE(fields[i].toDouble(), 0.0); // a handle has no velocity, and so no curve of it
                    QVERIFY(std::isnan(is));
                    continue;
                }
                QVERIFY2(std::abs(is - fields[i].toDouble()) <= 1e-9, qPrintable(line));
            }
        }
    }

    void distanceIsThatOfPythagoras()
    {
        const auto rows = rowsOf(scriptOf("pair"),
                                 {{QuantityKind::distance, "foot", "body"},
                                  of(QuantityKind::placeX),
                                  of(QuantityKind::placeY),
                                  of(QuantityKind::placeX, "body"),
                                  of(QuantityKind::placeY, "body")},
                                 60);
        QCOMPARE(rows.front()[0], std::sqrt(30.0 * 30.0 + 10.0 * 10.0));
        for (const auto &row : rows)
            QVERIFY(std::abs(row[0] - std::hypot(row[1] - row[3], row[2] - row[4])) < 1e-12);
    }

    void aQuantityThatTheSceneLacksIsExplainedInASentence_data()
    {
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("words");
        QTest::newRow("a body of another step") << "fall"
                                                << "y"
                                                << "foot7"
                                                << "There is no foot 7 in this step";
        QTest::newRow("an angle of a point") << "fall"
                                             << "angle"
                                             << "foot"
                                             << "have no angle";
        QTest::newRow("the velocity of what a rule places") << "puppet"
                                                            << "speed"
                                                            << "foot"
                                                            << "no velocity of its own";
        QTest::newRow("energy without inertia") << "puppet"
                                                << "energy"
                                                << ""
                                                << "the energy cannot be counted";
    }

    void aQuantityThatTheSceneLacksIsExplainedInASentence()
    {
        QFETCH(QString, step);
        QFETCH(QString, what);
        QFETCH(QString, body);
        QFETCH(QString, words);
        const sim::Scene scene = sim::Track(scriptOf(qPrintable(step)), 0).interval().scene;
        const Quantity quantity{*quantityKindFrom(what), body};
        const std::optional<NoValue> why = whyNot(quantity, scene);
        QVERIFY(why);
        const QString said = noValueWords(quantity, scene, *why);
        QVERIFY2(said.contains(words), qPrintable(said));
        const auto rows = rowsOf(scriptOf(qPrintable(step)), {quantity}, 3);
        QVERIFY(std::isnan(rows[2][0]));
    }

    void everyQuantityHasANameAUnitAndAnId()
    {
        QSet<QString> ids, titles;
        for (const QuantityKind what : quantityKinds()) {
            QCOMPARE(quantityKindFrom(idOf(what)), what);
            ids << idOf(what);
            titles << kindTitle(what);
            QVERIFY(!unitOf(what, false).isEmpty());
            QVERIFY(!kindHelp(what).isEmpty());
        }
        QCOMPARE(std::size_t(ids.size()), quantityKinds().size());
        QCOMPARE(std::size_t(titles.size()), quantityKinds().size());
    }

    void aTableHasEveryFrameWithAllDigits()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("fall.csv");
        NumberTable table(sheetOf("fall", 20'000), path);
        QSignalSpy written(&table, &NumberTable::written);
        QVERIFY(written.wait());
        const QStringList lines = QString::fromUtf8(tests::contentsOf(path)).split('\n');
        QCOMPARE(lines.size(), 20'003);
        QCOMPARE(lines[0], QString("\"frame\",\"y [px]\",\"a, \"\"down\"\"\""));
        QCOMPARE(lines[1], QString("0,10,"));
        sim::Track track(scriptOf("fall"), 0);
        track.seek({20'000, 0});
        QCOMPARE(lines[20'001].split(',')[1].toDouble(),
                 track.state().positionOf(0).y); // exactly the same number
        QCOMPARE(lines[20'001].split(',')[0], QString("20000"));
    }

    void aTableHasTheOldRunBesideTheNew()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("two.csv");
        NumberSheet sheet = sheetOf("swing", 10);
        sheet.comparison = sheet.run;
        sheet.comparison->values.set("k", 0.2);
        sheet.comparisonFrames = 5;
        sheet.comparisonName = "before: k 0.2";
        NumberTable table(sheet, path);
        QSignalSpy written(&table, &NumberTable::written);
        QVERIFY(written.wait());
        const QStringList lines = QString::fromUtf8(tests::contentsOf(path)).split('\n');
        QVERIFY(lines[0].endsWith("\"a, \"\"down\"\", before: k 0.2\""));
        const sim::Track old(*sheet.comparison, 0);
        const QStringList fifth = lines[6].split(','), sixth = lines[7].split(',');
        QVERIFY(fifth[1] != fifth[3]);
        QVERIFY(!fifth[3].isEmpty());
        QVERIFY(sixth[3].isEmpty() && !sixth[1].isEmpty()); // where it ends
    }

    void aTableThatCannotBeWrittenSaysSoAndACancelledOneLeavesNothing()
    {
        const QTemporaryDir folder;
        NumberTable nowhere(sheetOf("fall", 10), folder.filePath("no/such/folder/a.csv"));
        QSignalSpy failed(&nowhere, &NumberTable::failed);
        QVERIFY(failed.wait());
        QVERIFY(failed.front().front().toString().contains("Choose another folder"));

        const QString path = folder.filePath("long.csv");
        QFile before(path);
        QVERIFY(before.open(QIODevice::WriteOnly) && before.write("mine") == 4);
        before.close();
        NumberTable table(sheetOf("fall", 10'000'000), path);
        QSignalSpy progressed(&table, &NumberTable::progressed);
        QVERIFY(progressed.wait());
        QVERIFY(table.done() > 0.0 && table.done() < 1.0);
        table.cancel();
        QCOMPARE(tests::contentsOf(path), QByteArray("mine"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }
};

SUITE(tst_plot_quantities, PlotQuantities)
#include "tst_plot_quantities.moc"
