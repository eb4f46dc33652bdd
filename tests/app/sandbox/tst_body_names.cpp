// Renaming a point of a sandbox scene updates every reference to it and leaves the run unchanged.

#include "app/model/breakpoints/condition.h"
#include "app/model/sandbox/sandbox.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/sandbox/name_row.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/app/sandbox/sandbox_support.h"
#include "tests/suite.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

using namespace app;
using namespace tests;
using namespace sandbox_support;
using experiment_support::library;

namespace {

/// The first scene of the sandbox, whose second point is the one that moves.
struct NamesWorld
{
    NamesWorld() { session.openStep("sandbox", "build"); }
    const sim::Blueprint &plan() const { return editor.plan(); }
    QString name(int point) const { return QString::fromStdString(plan().points[std::size_t(point)].name); }
    const sim::Script &script() const { return session.timeline().script(); }
    QString lastSaid() const { return said.isEmpty() ? QString() : said.last().first().toString(); }
    sim::State stateAt(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        return session.timeline().state();
    }
    void carry()
    {
        session.playback().goTo({5, 0});
        session.input().grab(name(1));
        session.input().moveTo({300, 100});
        session.playback().goTo({9, 0});
        session.input().release();
    }

    Session session{library()};
    SandboxEditor editor{session};
    QSignalSpy said{&session.changes(), &ChangeNotifier::messageRequested};
};

constexpr auto bob = "bob";

}

class BodyNames : public QObject
{
    Q_OBJECT

private slots:
    void theRunAndItsInputStayTheSame()
    {
        NamesWorld world;
        world.carry();
        const sim::State before = world.stateAt(30);
        const sim::Script old = world.script();
        world.session.playback().goTo({});
        QVERIFY(world.editor.rename(1, bob));
        QCOMPARE(world.name(1), QString(bob));
        QVERIFY(sim::sameBits(world.stateAt(30), before));
        const QByteArray text = experimentText(world.session.experiment(), library());
        const Experiment read = parseExperiment(text, "x.json", library());
        QVERIFY(*read.script.values.blueprint == world.plan());
        QVERIFY(read.script.input == world.script().input);
        QVERIFY(sim::Timeline(read.script).track().interval().scene.find(bob) == 1);
        world.session.playback().goTo({});
        world.session.editor().undo();
        QVERIFY(world.plan() == *old.values.blueprint);
        QVERIFY(world.script().input == old.input);
        world.session.editor().redo();
        QCOMPARE(world.name(1), QString(bob));
        QVERIFY(sim::sameBits(world.stateAt(30), before));
    }

    void renamingKeepsTheBranches()
    {
        NamesWorld world;
        world.carry();
        const sim::State before = world.stateAt(30);
        world.session.playback().goTo({20, 0});
        world.session.editor().setParameter("gravity", 0.75);
        const Branches &branches = world.session.comparisons().branches();
        QCOMPARE(branches.all().size(), std::size_t(1));
        const int branch = branches.all().front().id;
        QVERIFY(world.session.comparisons().shown());
        world.session.playback().goTo({});
        QVERIFY(world.editor.rename(1, bob));
        QCOMPARE(branches.all().size(), std::size_t(1));
        QVERIFY(world.session.comparisons().shown());
        world.session.editor().goBackTo(branch);
        QCOMPARE(world.name(1), QString(bob));
        QVERIFY(sim::sameBits(world.stateAt(30), before));
    }

    void theSelectionAndBreakpointsFollowAlsoWithUndo()
    {
        NamesWorld world;
        const QString first = world.name(1);
        const QString condition = QStringLiteral("%1.y > 300 and distance(%1, %2) > 5");
        world.session.playback().breakpoints().add(condition.arg(first, world.name(0)));
        const auto shown = [&] { return world.session.playback().breakpoints().all().front().condition; };
        world.editor.choose({{1}, {}, {}});
        QVERIFY(world.editor.rename(1, bob));
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(shown(), condition.arg(bob, world.name(0)));
            QCOMPARE(world.session.selected(), QString(bob));
            QCOMPARE(world.editor.chosen().points, std::vector<int>{1});
            world.session.editor().undo();
            QCOMPARE(shown(), condition.arg(first, world.name(0)));
            QCOMPARE(world.session.selected(), first);
            QCOMPARE(world.editor.chosen().points, std::vector<int>{1});
            world.session.editor().redo();
        }
    }

    void aNameThatNothingCanReadIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("sentence");
        const QString shape = "A name is a letter from a to z, then up to 39 letters, digits or _.";
        QTest::newRow("nothing") << "" << shape;
        QTest::newRow("a digit first") << "2b" << shape;
        QTest::newRow("a space") << "left foot" << shape;
        QTest::newRow("an accent") << QString("Füße") << shape;
        QTest::newRow("a dot") << "left.foot" << shape;
        QTest::newRow("too long") << QString(41, 'a') << shape;
        QTest::newRow("a keyword") << "if"
                                   << "“if” is a word of the code. Choose another name, such as “if_1”.";
        QTest::newRow("a name of every listing") << "hand"
                                                 << "“hand” is a word of the code.";
        QTest::newRow("a word of conditions") << "frame"
                                              << "“frame” is a word of the code.";
        QTest::newRow("a parameter") << "gravity"
                                     << "“gravity” is a parameter.";
        QTest::newRow("taken") << "p0"
                               << "Another point is called “p0”.";
    }
    void aNameThatNothingCanReadIsRefused()
    {
        QFETCH(QString, name);
        QFETCH(QString, sentence);
        NamesWorld world;
        QVERIFY(world.editor.rename(0, "nail"));
        const int point = static_cast<int>(world.plan().points.size()); // of the new point
        world.editor.setTool(BuildTool::point);
        world.editor.use({60, 60}, -1);
        world.editor.use({90, 60}, -1);
        QCOMPARE(world.name(point), QString("p0"));
        const sim::Blueprint before = world.plan();
        const int edits = world.session.editor().undoStack().count();
        QVERIFY(!world.editor.rename(point + 1, name));
        QVERIFY2(world.lastSaid().startsWith(sentence), qPrintable(world.lastSaid()));
        QVERIFY(world.plan() == before);
        QCOMPARE(world.session.editor().undoStack().count(), edits);
    }

    void aNewNameWaitsForTheStartOfTheRun()
    {
        NamesWorld world;
        const QString name = world.name(1);
        world.session.playback().goTo({4, 0});
        QVERIFY(!world.editor.rename(1, bob));
        QVERIFY2(world.lastSaid().startsWith("You can only build"), qPrintable(world.lastSaid()));
        QCOMPARE(world.name(1), name);
    }

    void aNameThatYourCodeUsesStays()
    {
        NamesWorld world;
        QVERIFY(world.editor.rename(1, "lamp"));
        QJsonObject file =
            QJsonDocument::fromJson(experimentText(world.session.experiment(), library())).object();
        file["method"] = "listing"; // only a file has code for a scene of the sandbox
        file["code"] = "void frame()\n{\n    lamp.position.x += 1.0;\n}\n";
        world.session.open(parseExperiment(QJsonDocument(file).toJson(), "x.json", library()));
        QVERIFY(world.session.code().isRunning());
        const sim::Blueprint before = world.plan();
        const int edits = world.session.editor().undoStack().count();
        QVERIFY(!world.editor.rename(1, bob));
        QVERIFY2(world.lastSaid().startsWith("Your code computes this run, and it names the points."),
                 qPrintable(world.lastSaid()));
        QVERIFY(world.plan() == before);
        QCOMPARE(world.session.editor().undoStack().count(), edits);
        world.session.editor().setMethod("semi_implicit_euler"); // as the sentence says
        QVERIFY(world.editor.rename(1, bob));
        QCOMPARE(world.name(1), QString(bob));
    }

    void conditionsFollowARenamedBody_data()
    {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::newRow("numbers") << "p1.y > 3 and p1.vx<p10.x"
                                 << "bob.y > 3 and bob.vx<p10.x";
        QTest::newRow("functions") << "distance(p1, p2) < speed( p1 ) or not still(p1)"
                                   << "distance(bob, p2) < speed( bob ) or not still(bob)";
        QTest::newRow("second argument") << "distance(p2,p1) > abs(p1.x)"
                                         << "distance(p2,bob) > abs(bob.x)";
        QTest::newRow("a parameter") << "p1 > 2 and abs(p1) < 3"
                                     << "p1 > 2 and abs(p1) < 3";
        QTest::newRow("a creature's body") << "speed(p1.body) > 1 and p1.body.x > 2"
                                           << "speed(p1.body) > 1 and p1.body.x > 2";
        QTest::newRow("a text") << "phase == \"p1\""
                                << "phase == \"p1\"";
        QTest::newRow("no condition") << "p1.y = \"3"
                                      << "p1.y = \"3";
    }
    void conditionsFollowARenamedBody()
    {
        QFETCH(QString, before);
        QFETCH(QString, after);
        QCOMPARE(withBodyRenamed(before, "p1", "bob"), after);
    }

    void nameIsTypedInThePanel()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.click(fixture.plan().points[1].x);
        const auto name = [&] { return QString::fromStdString(fixture.plan().points[1].name); };
        const auto field = [&] { return fixture.panel().nameRow()->field(); };
        const QString first = name();
        PlotList &plots = fixture.window.plots().list();
        plots.add({{QuantityKind::placeY, first}});
        QTRY_VERIFY(fixture.row("x")->isVisible());
        QCOMPARE(field()->text(), first);
        QVERIFY(field()->accessibleName().endsWith(": Name"));
        QVERIFY(!field()->parentWidget()->toolTip().isEmpty());

        typeInto(*field(), "2 bobs"); // stays there to be corrected
        QCOMPARE(name(), first);
        QVERIFY(fixture.panel().nameRow()->whyNot().startsWith("A name is a letter"));
        QCOMPARE(field()->text(), QString("2 bobs"));
        QTest::keyClick(field(), Qt::Key_Escape);
        QCOMPARE(field()->text(), first);
        QVERIFY(fixture.panel().nameRow()->whyNot().isEmpty());

        typeInto(*field(), "bob");
        QCOMPARE(name(), QString("bob"));
        QCOMPARE(field()->text(), QString("bob"));
        QVERIFY(!field()->hasFocus()); // the next keys go to the run
        QCOMPARE(plots.plots().back().up.body, QString("bob"));
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Rename %1 to bob").arg(first));

        field()->setFocus(Qt::TabFocusReason);
        QTest::keyClick(field(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field(), "lamp");
        QTest::keyClick(field(), Qt::Key_Return);
        QCOMPARE(name(), QString("lamp"));
        QVERIFY(field()->hasFocus());
        QTest::keyClicks(field(), "weight"); // the name was selected
        QTest::keyClick(field(), Qt::Key_Tab);
        QCOMPARE(name(), QString("weight"));
        QVERIFY(fixture.row("x")->findChild<NumberBox *>()->hasFocus());
        QCOMPARE(fixture.row("x")->findChild<NumberBox *>()->accessibleName(),
                 QString("Point weight: x, px"));
        const QList<QLabel *> headings = fixture.panel().findChildren<QLabel *>("heading");
        QVERIFY(std::any_of(headings.begin(), headings.end(),
                            [](const QLabel *one) { return one->text() == "Point weight"; }));

        for (int i = 0; i < 3; ++i)
            fixture.session.editor().undo();
        QCOMPARE(name(), first);
        QCOMPARE(field()->text(), first);
        QCOMPARE(plots.plots().back().up.body, first);
        QTest::keyClick(&fixture.view, Qt::Key_A, Qt::ControlModifier);
        QVERIFY(!fixture.panel().nameRow()); // of several points
    }
};

SUITE(tst_body_names, BodyNames)
#include "tst_body_names.moc"
