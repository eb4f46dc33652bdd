// The map of concepts: it fits, it can be read without colours, and mouse and keys open steps with it.

#include "app/ui/help/tour.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step_button.h"
#include "app/ui/map/concept_button.h"
#include "app/ui/map/concept_view.h"
#include "app/ui/map/map_page.h"
#include "app/ui/window/introduction.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QCursor>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <QWindow>

using namespace app;
using namespace tests;

namespace {

/// The window on the lessons of the program, with the map open.
struct MapFixture : WindowFixture
{
    explicit MapFixture(WindowSetup setup = {}) : WindowFixture(std::move(setup))
    {
        QCursor::setPos({}); // not on the map
        QTest::keyClick(&window, Qt::Key_F2);
        settle();
    }

    MapPage &page() const { return part<MapPage>(); }
    ConceptView &map() const { return *page().findChild<ConceptView *>(); }
    ConceptButton &node(const QString &id) const { return *page().findChild<ConceptButton *>(id); }
    std::vector<ConceptButton *> nodes() const
    {
        const auto found = page().findChildren<ConceptButton *>();
        return {found.begin(), found.end()};
    }
    QString text() const { return page().findChild<NarrationText *>("conceptText")->toPlainText(); }
    std::size_t indexOf(const QString &id) const
    {
        const std::vector<ConceptNode> &all = map().nodes();
        return static_cast<std::size_t>(
            std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.id == id; }) -
            all.begin());
    }
    /// Ticks off all of a step.
    void finish(const QString &lesson, const QString &step)
    {
        const lessons::Step &done = *library.lesson(lesson)->step(step);
        for (int i = 0; i < static_cast<int>(done.tries.size()); ++i)
            session.progress().markDone(lesson, step, i);
        for (const lessons::CodeTask &task : done.codeTasks)
            session.progress().markWritten(lesson, step, task.id);
    }
};

/// Returns how many pixels of a box differ from its middle, without its text: a rough measure of its outline.
int outlinePixels(ConceptButton &button)
{
    const QImage image = button.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
    int count = 0;
    const int y = 1; // the upper edge
    for (int x = 8; x < image.width() - 8; ++x)
        count += qAbs(qGray(image.pixel(x, y)) - qGray(image.pixel(x, 5))) > 20 ? 1 : 0;
    return count;
}

}

class ConceptMapTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void mapFitsWithoutScrolling_data();
    void mapFitsWithoutScrolling();
    void statesAreReadableWithoutColour();
    void hoveringDescribesAConceptAndHighlightsItsNeighbours();
    void arrowKeysMoveAndEnterOpens();
    void tabGoesFromRowToRow();
    void aClickOpensTheStepAndClosesTheMap();
    void theButtonOpensWhatCanComeNext();
    void progressIsFollowed();
    void everyNodeHasANameAndAText();
    void theButtonAboveTheLessonsOpensIt();
    void escapeClosesIt();
    void lessonsWithoutConceptsHaveNoMap();
    void aNewLearnerSeesItAfterTheTour();
};

void ConceptMapTest::mapFitsWithoutScrolling_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("language");
    QTest::addColumn<Scheme>("scheme");
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        for (const char *language : {"", "de"}) {
            for (const Scheme scheme : {Scheme::light, Scheme::dark})
                QTest::addRow("%d %s%s", size.width(), language, scheme == Scheme::dark ? " dark" : "")
                    << size << QString(language) << scheme;
        }
    }
}

void ConceptMapTest::mapFitsWithoutScrolling()
{
    QFETCH(QSize, size);
    QFETCH(QString, language);
    QFETCH(Scheme, scheme);
    MapFixture fixture({.size = size, .language = language, .scheme = scheme});
    QVERIFY(fixture.page().isVisible());
    QVERIFY(fixture.page().width() <= size.width() && fixture.page().height() <= size.height());
    const auto *area = fixture.page().findChild<QScrollArea *>();
    QCOMPARE(area->horizontalScrollBar()->maximum(), 0);
    QCOMPARE(area->verticalScrollBar()->maximum(), 0);
    const std::vector<ConceptButton *> nodes = fixture.nodes();
    QVERIFY(nodes.size() >= 30);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        QVERIFY(fixture.map().rect().contains(nodes[i]->geometry()));
        QVERIFY2(QFontMetrics(fixture.theme.ui(12, QFont::DemiBold)).horizontalAdvance(nodes[i]->text()) <=
                     nodes[i]->width() - 18,
                 qPrintable(nodes[i]->text()));
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(!nodes[i]->geometry().adjusted(-3, -3, 3, 3).intersects(nodes[j]->geometry()));
    }
    // The longest text about a concept has room, too.
    auto *text = fixture.page().findChild<NarrationText *>("conceptText");
    for (ConceptButton *one : nodes) {
        emit one->pointed(true);
        QVERIFY2(text->heightForWidth(text->width()) <= text->height(), qPrintable(fixture.text()));
    }
    for (const QLabel *label : fixture.page().findChildren<QLabel *>())
        QVERIFY2(label->minimumSizeHint().width() <= label->width(), qPrintable(label->text()));
}

void ConceptMapTest::statesAreReadableWithoutColour()
{
    MapFixture fixture;
    fixture.finish("single_spring", "drag");
    const ConceptButton &known = fixture.node("frame"), &next = fixture.node("spring_pull"),
                        &later = fixture.node("overshoot");
    QCOMPARE(known.state(), ConceptState::known);
    QCOMPARE(next.state(), ConceptState::next);
    QCOMPARE(later.state(), ConceptState::later);
    QCOMPARE(known.accessibleName(), known.text() + ", known");
    QCOMPARE(next.accessibleName(), next.text() + ", can come next");
    QCOMPARE(later.accessibleName(), later.text() + ", for later");
    // The outline of later concepts is dashed.
    const int full = outlinePixels(fixture.node("spring_pull"));
    const int dashed = outlinePixels(fixture.node("overshoot"));
    QVERIFY2(dashed < full * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(dashed).arg(full)));
}

void ConceptMapTest::hoveringDescribesAConceptAndHighlightsItsNeighbours()
{
    MapFixture fixture;
    ConceptButton &pull = fixture.node("spring_pull");
    const QString before = fixture.text();
    QVERIFY(!fixture.map().lit());
    // The pointer is moved within the window of the map: QTest::mouseMove() on a widget asks for the window below it, and the
    // main window is there, too.
    const auto pointAt = [&](QPoint at) { QTest::mouseMove(fixture.page().windowHandle(), at); };
    pointAt({3, 3}); // Qt tells of widgets that the pointer enters from its second place on
    pointAt(pull.mapTo(&fixture.page(), pull.rect().center()));
    QTRY_COMPARE(fixture.map().lit(), std::optional(fixture.indexOf("spring_pull")));
    const ConceptNode &node = fixture.map().nodes()[fixture.indexOf("spring_pull")];
    QVERIFY(fixture.text().startsWith(node.title + '.'));
    QVERIFY(fixture.text().contains(node.where));
    for (std::size_t i = 0; i < fixture.map().nodes().size(); ++i) {
        const bool isJoined = i == fixture.indexOf("spring_pull") ||
                              std::find(node.restsOn.begin(), node.restsOn.end(), i) != node.restsOn.end() ||
                              std::find(node.carries.begin(), node.carries.end(), i) != node.carries.end();
        QCOMPARE(fixture.map().button(i).isFaded(), !isJoined);
    }
    QVERIFY(!node.restsOn.empty());
    for (const std::size_t base : node.restsOn)
        QVERIFY(fixture.text().contains(fixture.map().nodes()[base].title));
    pointAt({3, 3});
    QTRY_VERIFY(!fixture.map().lit());
    QCOMPARE(fixture.text(), before);
    QVERIFY(!fixture.node("wall").isFaded());
}

void ConceptMapTest::arrowKeysMoveAndEnterOpens()
{
    MapFixture fixture;
    const auto focus = [] { return qobject_cast<ConceptButton *>(QApplication::focusWidget()); };
    QVERIFY(focus()); // the first that can come next
    QCOMPARE(focus()->state(), ConceptState::next);
    QVERIFY(!fixture.map().lit());
    const QRect first = focus()->geometry();
    QTest::keyClick(focus(), Qt::Key_Down);
    QVERIFY(focus() && focus()->geometry().top() > first.bottom());
    QCOMPARE(fixture.map().lit(), std::optional(fixture.indexOf(focus()->objectName())));
    QTest::keyClick(focus(), Qt::Key_Down);
    const QRect second = focus()->geometry();
    QTest::keyClick(focus(), Qt::Key_Left);
    QTest::keyClick(focus(), Qt::Key_Left);
    QTest::keyClick(focus(), Qt::Key_Right);
    QCOMPARE(focus()->geometry().top(), second.top());
    QTest::keyClick(focus(), Qt::Key_Up);
    QVERIFY(focus()->geometry().bottom() < second.top());
    const ConceptNode node = fixture.map().nodes()[fixture.indexOf(focus()->objectName())];
    QTest::keyClick(focus(), Qt::Key_Return);
    QVERIFY(!fixture.page().isVisible());
    QCOMPARE(fixture.session.lesson().id, node.lesson);
    QCOMPARE(fixture.session.step().id, node.step);
}

void ConceptMapTest::tabGoesFromRowToRow()
{
    MapFixture fixture;
    QList<int> tops;
    QWidget *first = QApplication::focusWidget();
    for (QWidget *at = first; qobject_cast<ConceptButton *>(at); at = QApplication::focusWidget()) {
        tops << at->y();
        QTest::keyClick(at, Qt::Key_Tab);
        if (tops.size() > static_cast<qsizetype>(fixture.nodes().size()))
            break;
    }
    QVERIFY(tops.size() > 10 && tops.size() <= static_cast<qsizetype>(fixture.nodes().size()));
    QVERIFY(std::is_sorted(tops.begin(), tops.end()));
}

void ConceptMapTest::aClickOpensTheStepAndClosesTheMap()
{
    MapFixture fixture;
    QTest::mouseClick(&fixture.node("wall"), Qt::LeftButton);
    QVERIFY(!fixture.page().isVisible());
    QCOMPARE(fixture.session.lesson().id, QString("gravity_walls"));
    QCOMPARE(fixture.session.step().id, QString("walls"));
}

void ConceptMapTest::theButtonOpensWhatCanComeNext()
{
    MapFixture fixture;
    auto *next = fixture.page().findChild<StepButton *>("nextConcept");
    QVERIFY(next->accessibleName().startsWith("Begin: "));
    fixture.finish("single_spring", "drag");
    QVERIFY(next->accessibleName().startsWith("Go on: "));
    QTest::mouseClick(next, Qt::LeftButton);
    QVERIFY(!fixture.page().isVisible());
    QCOMPARE(fixture.session.lesson().id, QString("single_spring"));
    QVERIFY(fixture.session.step().id != "drag");
}

void ConceptMapTest::progressIsFollowed()
{
    MapFixture fixture;
    const auto counted = [&] {
        for (const QLabel *one : fixture.page().findChildren<QLabel *>("caption")) {
            if (one->text().startsWith("You know "))
                return one->text();
        }
        return QString();
    };
    QVERIFY(counted().startsWith("You know 0 of "));
    for (const LessonEntry &lesson : fixture.library.lessons) {
        for (const lessons::Step &step : lesson.steps)
            fixture.finish(lesson.id, step.id);
    }
    QVERIFY(counted().startsWith(QStringLiteral("You know %1 of %1 ").arg(fixture.nodes().size())));
    QVERIFY(!fixture.page().findChild<StepButton *>("nextConcept")->isVisible());
    for (const LessonEntry &lesson : fixture.session.library().lessons)
        fixture.session.progress().forgetLesson(lesson.id);
    QVERIFY(counted().startsWith("You know 0 of "));
}

void ConceptMapTest::everyNodeHasANameAndAText()
{
    MapFixture fixture;
    for (ConceptButton *one : fixture.nodes()) {
        QAccessibleInterface *reader = QAccessible::queryAccessibleInterface(one);
        QVERIFY(reader);
        QCOMPARE(reader->role(), QAccessible::Button);
        QVERIFY(reader->text(QAccessible::Name).startsWith(one->text()));
        QVERIFY(reader->text(QAccessible::Description).size() > 20);
        QVERIFY(!one->toolTip().isEmpty());
    }
    for (const char *name : {"closeMap", "nextConcept"})
        QVERIFY(!fixture.page().findChild<QPushButton *>(name)->toolTip().isEmpty());
}

void ConceptMapTest::theButtonAboveTheLessonsOpensIt()
{
    WindowFixture fixture;
    auto &button = fixture.part<QToolButton>("map");
    QVERIFY(button.isVisible() && button.toolTip().contains("F2"));
    QCOMPARE(button.accessibleName(), QString("Map of concepts"));
    QTest::mouseClick(&button, Qt::LeftButton);
    QVERIFY(fixture.part<MapPage>().isVisible());
}

void ConceptMapTest::escapeClosesIt()
{
    MapFixture fixture;
    const QString step = fixture.session.step().id;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!fixture.page().isVisible());
    QCOMPARE(fixture.session.step().id, step);
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    QTest::keyClick(&fixture.window, Qt::Key_F2); // and again
    QVERIFY(fixture.page().isVisible());
    QTest::mouseClick(fixture.page().findChild<QPushButton *>("closeMap"), Qt::LeftButton);
    QVERIFY(!fixture.page().isVisible());
}

void ConceptMapTest::lessonsWithoutConceptsHaveNoMap()
{
    WindowFixture fixture({.lesson = {}, .library = twoLessons()});
    const auto &command = fixture.actionCalled("Map of concepts");
    QVERIFY(!command.isEnabled() && !command.toolTip().isEmpty());
    fixture.window.introduction().showMap();
    QVERIFY(!fixture.window.findChild<MapPage *>());
}

void ConceptMapTest::aNewLearnerSeesItAfterTheTour()
{
    WindowFixture fixture;
    fixture.window.introduction().welcome();
    QVERIFY(fixture.part<Tour>().isRunning());
    QVERIFY(!fixture.window.findChild<MapPage *>());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(fixture.part<MapPage>().isVisible());
    fixture.part<MapPage>().close();
    fixture.window.introduction().startTour(); // taken again from the menu: no map
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!fixture.part<MapPage>().isVisible());
}

SUITE(tst_concept_map, ConceptMapTest)
#include "tst_concept_map.moc"
