// The views of the accuracy panel: their plots, their exports, and the remarks on their numbers.

#include "app/model/text/accuracy_text.h"
#include "app/ui/accuracy/method_colors.h"
#include "app/ui/accuracy/order_plot.h"
#include "app/ui/accuracy/run_plot.h"
#include "app/ui/accuracy/study_marks.h"
#include "app/ui/plots/plot_export.h"
#include "sim/methods/methods.h"
#include "tests/app/panels/accuracy_support.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <set>

using namespace app;
using namespace tests;
using accuracy_support::AccuracyFixture;

class AccuracyViewsTest : public QObject
{
    Q_OBJECT

private slots:
    void theUnstableAreMarkedAndNamed();
    void errorOfZeroIsDrawnBelowTheNumbersOfTheAxis();
    void namesAtLinesCoverNeitherEachOtherNorMarks();
    void theTabsShowTheThreeViews();
    void theOrderViewMeasuresTheSlope();
    void theRunViewDrawsOneRowAMethodWithTheOneInUse();
    void everyMethodHasAnInkOfItsOwn();
    void numbersOfTheViewThatIsSeenAreSaved();
    void thePlotIsSavedAsPdf();
    void remarksSayWhatTheNumbersDependOn_data();
    void remarksSayWhatTheNumbersDependOn();
};

void AccuracyViewsTest::theUnstableAreMarkedAndNamed()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const sim::AccuracyRow &unstable = fixture.study.accuracy()->rows.front();
    const QPoint mark = fixture.spotOf(unstable.setup.method->id(), unstable.setup.step);
    QVERIFY(mark.y() < fixture.plot().axisRect()->top() + 40);
    auto *named = fixture.panel.findChild<QLabel *>("failure");
    QVERIFY(named->isVisible());
    QVERIFY(named->text().contains(QString::fromStdString(unstable.setup.method->title())));
}

void AccuracyViewsTest::errorOfZeroIsDrawnBelowTheNumbersOfTheAxis()
{
    constexpr double height = 400.0; // px of the screen
    const ErrorScale plain = errorScale({1e-3, 1e-6, 10.0}, 30.0, height);
    QCOMPARE(plain.floor, 0.0);
    QCOMPARE(plain.lower, 1e-6 / 4.0);
    const ErrorScale scale = errorScale({1e-3, 0.0, 1e-6, 10.0, 0.0}, 30.0, height);
    QCOMPARE(scale.upper, plain.upper);
    QCOMPARE(scale.lowest, plain.lower); // the numbers of the axis end where they did
    QCOMPARE(scale.place(1e-6), 1e-6);
    QVERIFY(scale.place(0.0) < scale.lowest && scale.place(0.0) > scale.lower);
    // The floor takes some pixels, not decades, so most of the axis is left for errors above 0.
    const double axis = std::log10(scale.upper / scale.lower);
    QVERIFY(std::log10(scale.upper / scale.lowest) > 0.9 * axis);
    QVERIFY(std::log10(scale.lowest / scale.floor) / axis * height > 15.0);
}

void AccuracyViewsTest::namesAtLinesCoverNeitherEachOtherNorMarks()
{
    const QRectF area(0.0, 0.0, 480.0, 220.0);
    const QFont font = Theme(Scheme::light).ui(12);
    std::vector<EndLabel> labels;
    std::vector<QRectF> marks;
    for (int i = 0; i < 12; ++i) { // all end within a few px
        const QPointF end(200.0 + 3.0 * i, 100.0 + 4.0 * i);
        labels.push_back({end, QString("a method called %1").arg(i), Qt::black});
        marks.emplace_back(end.x() - 6.0, end.y() - 6.0, 12.0, 12.0);
    }
    LabelPlaces places(marks);
    const std::vector<PlacedLabel> placed = placeEndLabels(labels, font, area, places);
    QCOMPARE(placed.size(), labels.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        QVERIFY(area.contains(placed[i].box));
        for (const QRectF &mark : marks)
            QVERIFY(!placed[i].box.intersects(mark));
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(!placed[i].box.intersects(placed[j].box));
    }
}

void AccuracyViewsTest::theTabsShowTheThreeViews()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const QList<QToolButton *> tabs = fixture.panel.findChildren<QToolButton *>("tab");
    QCOMPARE(tabs.size(), 3);
    for (int i = 0; i < 3; ++i) {
        QTest::mouseClick(tabs[i], Qt::LeftButton);
        QCOMPARE(int(fixture.panel.view()), i);
        QCOMPARE(fixture.plot().isVisible(), i == 0);
        QVERIFY(!fixture.panel.grab().isNull());
    }
    QVERIFY(!fixture.panel.findChild<OrderPlot *>()->spots().empty());
}

void AccuracyViewsTest::theOrderViewMeasuresTheSlope()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const sim::MethodPtr method = sim::findMethod("semi_implicit_euler");
    QCOMPARE(OrderPlot::orderWords(*fixture.study.accuracy(), *method),
             QString("Semi-implicit Euler: 1.0, as expected"));
    sim::Accuracy flat = *fixture.study.accuracy();
    for (sim::AccuracyRow &row : flat.rows)
        row.error = 1.0;
    QCOMPARE(OrderPlot::orderWords(flat, *method), QString("Semi-implicit Euler: 0.0 of 1"));
}

void AccuracyViewsTest::theRunViewDrawsOneRowAMethodWithTheOneInUse()
{
    AccuracyFixture fixture;
    fixture.world.session.editor().use(sim::findMethod("semi_implicit_euler"), sim::StepSize::ofLength(0.25));
    QVERIFY(fixture.measured());
    fixture.panel.setView(AccuracyPanel::overTheRun);
    const auto &rows = fixture.panel.findChild<RunPlot *>()->rows();
    QCOMPARE(rows.size(), sim::allMethods().size());
    bool used = false;
    for (const std::size_t row : rows)
        used |= &fixture.study.accuracy()->rows[row] == fixture.study.inUse();
    QVERIFY(used);
}

void AccuracyViewsTest::everyMethodHasAnInkOfItsOwn()
{
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        const Theme theme(scheme);
        std::set<std::pair<QRgb, int>> inks;
        std::set<int> shapes;
        for (const sim::MethodPtr &method : sim::allMethods()) {
            const MethodColors ink = inkOf(*method, theme);
            inks.insert({ink.color.rgb(), ink.shape % markerShapes});
            shapes.insert(ink.shape % markerShapes);
        }
        QCOMPARE(inks.size(), sim::allMethods().size());
        QCOMPARE(shapes.size(), std::min<std::size_t>(markerShapes, sim::allMethods().size()));
    }
}

void AccuracyViewsTest::numbersOfTheViewThatIsSeenAreSaved()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const sim::Accuracy &found = *fixture.study.accuracy();
    const QTemporaryDir folder;
    const auto saved = [&](AccuracyPanel::View view) {
        fixture.panel.setView(view);
        fixture.panel.exports().saveNumbers(folder.filePath("a.csv"));
        return QString::fromUtf8(tests::contentsOf(folder.filePath("a.csv"))).trimmed().split('\n');
    };
    for (const AccuracyPanel::View view : {AccuracyPanel::errorAgainstTime, AccuracyPanel::order}) {
        const QStringList lines = saved(view);
        QVERIFY(lines[0].startsWith("method,order,"));
        int line = 1;
        for (const sim::AccuracyRow &row : found.rows) {
            if (row.outcome != sim::Outcome::measured)
                continue;
            const QStringList fields = lines[line++].split(',');
            QCOMPARE(fields[0], QString("\"%1\"").arg(QString::fromStdString(row.setup.method->id())));
            QCOMPARE(fields[row.setup.step.isAdaptive() ? 3 : 2].toDouble(),
                     row.setup.step.isAdaptive() ? row.setup.step.tolerance : row.setup.step.h);
            QCOMPARE(fields[4].toDouble(), row.error);
            QCOMPARE(fields[6].toDouble(), row.nsPerFrame);
            QCOMPARE(fields[8], QString(row.front ? "1" : "0"));
        }
        QCOMPARE(line, lines.size());
    }
    const QStringList run = saved(AccuracyPanel::overTheRun);
    QVERIFY2(run[0].startsWith("frame,\""), qPrintable(run[0]));
    QVERIFY(run.size() > 2);
}

void AccuracyViewsTest::thePlotIsSavedAsPdf()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const QTemporaryDir folder;
    QVERIFY(fixture.panel.exports().savePicture(folder.filePath("a.pdf")));
    QFile file(folder.filePath("a.pdf"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith("%PDF"));
}

void AccuracyViewsTest::remarksSayWhatTheNumbersDependOn_data()
{
    QTest::addColumn<sim::Accuracy>("accuracy");
    QTest::addColumn<QString>("part");
    sim::Accuracy noisy;
    noisy.noise = 0.3;
    QTest::newRow("a noisy machine") << noisy << "busy with other things";
    sim::Accuracy chaotic;
    chaotic.span = 200;
    chaotic.horizon = 80;
    chaotic.reference.end = sim::ReferenceRun::End::diverged;
    QTest::newRow("a horizon") << chaotic << "up to frame 80 of 200";
    sim::Accuracy jumping;
    jumping.reference.kind = sim::ReferenceRun::Kind::selfRefinement;
    jumping.reference.method = "own_refinement";
    QTest::newRow("no continuous limit") << jumping << "no exact motion to compare with";
    sim::Accuracy unfit;
    unfit.rows.resize(1);
    unfit.rows[0].setup.method = sim::findMethod("semi_implicit_euler");
    unfit.rows[0].outcome = sim::Outcome::doesNotFit;
    QTest::newRow("a method that does not fit") << unfit << "Semi-implicit Euler";
}

void AccuracyViewsTest::remarksSayWhatTheNumbersDependOn()
{
    QFETCH(sim::Accuracy, accuracy);
    QFETCH(QString, part);
    SessionFixture world;
    AccuracyStudy study(
        world.session.run(), world.session.editor(),
        [&](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) { return accuracy; });
    AccuracyPanel panel(study, world.session.preview(), world.theme);
    show(panel, {560, 560});
    QTRY_COMPARE(study.stage(), AccuracyStudy::Stage::done);
    QVERIFY2(panel.remarks().contains(part), qPrintable(panel.remarks()));
}

SUITE(tst_accuracy_views, AccuracyViewsTest)
#include "tst_accuracy_views.moc"
