// The help page, dock titles, the focus ring and the height of texts.

#include "app/ui/dock/button_flow.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/progress_line.h"
#include "app/ui/help/help_page.h"
#include "app/ui/help/key_caps.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step_button.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFocusFrame>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QTextBlock>
#include <QTextLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

using namespace app;
using namespace tests;

class PanelPartsTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { Theme(Scheme::light).apply(*qApp); }
    void init() { QSettings().clear(); }

    void theHelpPageListsEveryActionThatHasAShortcut();
    void groupsOfTheHelpPageStandInTheOrderInWhichTheyAreAdded();
    void theHelpPageHasMoreColumnsBeforeItScrolls();
    void aLongGestureOfTheHelpPageIsBelowItsText();
    void escapeClosesTheHelpPage();
    void aDockTitleIsAsHighAsItsDockExpects();
    void tabPutsARingRoundAControl();
    void aProgressLinePaintsOnlyWithAllElse();
    void aTextKnowsItsHeightAtEachWidthAfterEachChange();
    void noLineBreaksInsideAnIncrement();
    void aCopiedIncrementIsPlainCode();
    void aLineIsAboveButtonsThatCoverAText();
};

void PanelPartsTest::theHelpPageListsEveryActionThatHasAShortcut()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    QAction play("&Play or pause");
    play.setShortcut(Qt::Key_Space);
    QAction phase("&Next phase…");
    phase.setShortcuts({QKeySequence("Shift+Right"), QKeySequence("Ctrl++")});
    QAction silent("Without a key");
    page.addAction("Time", &play);
    page.addAction("Time", &phase);
    page.addAction("Time", &silent);
    page.addGesture("Picture", "Drag a body", "grab it");
    show(page, {800, 600});
    QStringList listed;
    for (const QLabel *label : page.findChildren<QLabel *>("action"))
        listed.push_back(label->accessibleName());
    listed.sort();
    const QStringList expected = {"Grab it: Drag a body", "Next phase: Shift → or Ctrl +",
                                  "Play or pause: Space"};
    QCOMPARE(listed, expected);
    const auto keys = page.findChildren<KeyCaps *>();
    QCOMPARE(keys.size(), expected.size());
    for (const KeyCaps *caps : keys)
        QVERIFY(caps->isVisible() && caps->width() == caps->sizeHint().width());
}

void PanelPartsTest::groupsOfTheHelpPageStandInTheOrderInWhichTheyAreAdded()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    for (const char *group : {"Time", "Picture", "Empty", "Code"})
        page.addGroup(group);
    for (int i = 0; i < 9; ++i)
        page.addGesture("Code", "Press", "do it");
    page.addGesture("Picture", "Drag", "move it");
    page.addGesture("Time", "Drag", "go");
    show(page, {800, 600});
    const auto place = [&](const QString &name) {
        for (const QLabel *label : page.findChildren<QLabel *>("heading")) {
            if (label->text() == name && label->isVisible())
                return label->mapTo(&page, QPoint());
        }
        return QPoint(-1, -1);
    };
    QCOMPARE(place("Empty"), QPoint(-1, -1));
    QVERIFY(place("Time").x() >= 0 && place("Time").x() < place("Picture").x());
    QCOMPARE(place("Time").y(), place("Picture").y());
    QVERIFY(place("Code").y() > place("Time").y());
}

void PanelPartsTest::theHelpPageHasMoreColumnsBeforeItScrolls()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    for (int group = 0; group < 12; ++group) {
        for (int i = 0; i < 8; ++i)
            page.addGesture(QString("Group %1").arg(group), "Press", "do it");
    }
    show(page, {800, 600});
    const auto columns = [&](QSize screen) {
        page.fitTo(screen);
        settle();
        std::set<int> places;
        for (const QLabel *label : page.findChildren<QLabel *>("heading"))
            places.insert(label->mapTo(&page, QPoint()).x());
        return places.size();
    };
    const QScrollBar *bar = page.findChild<QScrollArea *>()->verticalScrollBar();
    QCOMPARE(columns({1280, 800}), std::size_t{2});
    QVERIFY(bar->maximum() > 0);
    QCOMPARE(columns({1600, 1200}), std::size_t{3});
    QCOMPARE(bar->maximum(), 0);
    QCOMPARE(columns({1920, 1080}), std::size_t{4});
    QCOMPARE(bar->maximum(), 0);
    QCOMPARE(columns({1920, 2000}), std::size_t{2}); // nothing scrolls there
    QCOMPARE(bar->maximum(), 0);
}

void PanelPartsTest::aLongGestureOfTheHelpPageIsBelowItsText()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    page.addGesture("Code", "Click", "set a breakpoint");
    page.addGesture("Code", "Ctrl and a click left of a line, or F9, in the listing", "remove it");
    show(page, {800, 600});
    const auto placesOf = [&page](const QString &text) {
        for (const QLabel *label : page.findChildren<QLabel *>("action")) {
            if (label->text() != text)
                continue;
            for (const KeyCaps *caps : page.findChildren<KeyCaps *>()) {
                if (label->accessibleName().endsWith(caps->accessibleName()))
                    return std::pair(label->geometry(), caps->geometry());
            }
        }
        return std::pair(QRect(), QRect());
    };
    const auto [text, caps] = placesOf("Set a breakpoint");
    QVERIFY(!text.isEmpty() && caps.left() > text.right());
    const auto [above, below] = placesOf("Remove it");
    QVERIFY(!above.isEmpty() && below.top() > above.bottom());
    QVERIFY(above.width() >= below.width()); // all of the column is for the text
}

void PanelPartsTest::escapeClosesTheHelpPage()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    show(page, {800, 600});
    QVERIFY(!page.isModal());
    QTest::keyClick(&page, Qt::Key_Escape);
    QVERIFY(!page.isVisible());
}

void PanelPartsTest::aDockTitleIsAsHighAsItsDockExpects()
{
    Theme theme(Scheme::light);
    PanelTitle title("Code", theme);
    title.setCaption("values of foot 0");
    auto *button = new QToolButton;
    button->setFixedSize(28, 28);
    title.addAction(button);
    QCOMPARE(title.sizeHint().height(), 36);
    QCOMPARE(title.minimumSizeHint().height(), 36);
    show(title, {400, 36});
    QCOMPARE(title.findChild<QLabel *>("caption")->text(), QString("values of foot 0"));
    title.resize(140, 36);
    QVERIFY(title.rect().contains(button->geometry()));
    QVERIFY(title.findChild<QLabel *>("caption")->text().endsWith(QChar(0x2026)));
    QCOMPARE(title.findChild<QLabel *>("caption")->toolTip(), QString("values of foot 0"));
}

void PanelPartsTest::tabPutsARingRoundAControl()
{
    SessionFixture world;
    world.session.openFollowing();
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    auto *back = panel.findChild<QPushButton *>("back");
    QWidget *next = panel.findChild<StepButton *>("next");
    const auto ring = [&]() -> QWidget * {
        const auto *frame = panel.findChild<QFocusFrame *>();
        return frame && frame->isVisible() ? frame->widget() : nullptr;
    };
    back->setFocus(Qt::MouseFocusReason);
    QVERIFY(!ring());
    QTest::keyClick(back, Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), next);
    QCOMPARE(ring(), next);
    QTest::mousePress(back, Qt::LeftButton); // a press does not take the focus
    QCOMPARE(ring(), next);
    QTest::mouseRelease(back, Qt::LeftButton, {}, {-50, -50});
}

void PanelPartsTest::aProgressLinePaintsOnlyWithAllElse()
{
    QWidget page;
    ProgressLine line("How far it is", &page);
    line.setGeometry(10, 10, 200, 6);
    show(page, {300, 100});
    PaintCounter paints(line);
    line.setShare(0.25);
    line.setShare(0.5);
    QCOMPARE(paints.count, 0); // not in the middle of a change
    QTRY_COMPARE(paints.count, 1);
    QCOMPARE(line.value(), 50);
    QCOMPARE(line.accessibleName(), QString("How far it is"));
    line.setShare(0.5);
    settle();
    QCOMPARE(paints.count, 1); // nothing is new
}

void PanelPartsTest::aTextKnowsItsHeightAtEachWidthAfterEachChange()
{
    constexpr int line = 20, gap = 6, wide = 300, narrow = 60; // px; the narrow one holds one word
    Theme theme(Scheme::light);
    NarrationText text(theme);
    text.setText("spring foot");
    for (int i = 0; i < 2; ++i) { // asked for again
        QCOMPARE(text.heightForWidth(wide), line);
        QCOMPARE(text.heightForWidth(narrow), 2 * line);
    }
    text.setText("spring foot\n\nbody");
    QCOMPARE(text.heightForWidth(wide), 2 * line + gap);
    QCOMPARE(text.heightForWidth(narrow), 3 * line + gap);
    text.setLarge(true);
    QCOMPARE(text.heightForWidth(wide), 2 * (line + 2) + gap);
}

void PanelPartsTest::noLineBreaksInsideAnIncrement()
{
    Theme theme(Scheme::light);
    NarrationText text(theme);
    text.setText("`for (int i = 0; i < n; i++)` counts");
    const QTextBlock block = text.document()->firstBlock();
    const auto first = static_cast<int>(block.text().indexOf('+'));
    const auto last = static_cast<int>(block.text().lastIndexOf('+'));
    QVERIFY(first >= 0 && last > first);
    int mostLines = 0;
    for (int width = 60; width <= 300; ++width) {
        text.document()->setTextWidth(width);
        const QTextLayout &lines = *block.layout();
        QVERIFY2(lines.lineForTextPosition(first).lineNumber() ==
                     lines.lineForTextPosition(last).lineNumber(),
                 qPrintable(QString("%1 px").arg(width)));
        mostLines = std::max(mostLines, lines.lineCount());
    }
    QVERIFY(mostLines > 2);
}

void PanelPartsTest::aCopiedIncrementIsPlainCode()
{
    Theme theme(Scheme::light);
    NarrationText text(theme);
    text.setText("`i++` adds 1");
    text.selectAll();
    text.copy();
    QCOMPARE(text.accessibleName(), QString("i++ adds 1"));
    QCOMPARE(QApplication::clipboard()->text(), QString("i++ adds 1"));
}

void PanelPartsTest::aLineIsAboveButtonsThatCoverAText()
{
    QScrollArea area;
    area.setWidgetResizable(true);
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    auto *text = new QLabel("text", page);
    text->setFixedHeight(400);
    auto *buttons = new ButtonFlow(page);
    buttons->add<QToolButton>("start", "Start", {});
    column->addWidget(text);
    column->addWidget(buttons);
    area.setWidget(page);
    show(area, {200, 200});
    auto *edge = page->findChild<QFrame *>("divider");
    QTRY_VERIFY(edge->isVisible());
    area.verticalScrollBar()->setValue(area.verticalScrollBar()->maximum());
    QTRY_VERIFY(!edge->isVisible());
}

SUITE(tst_panel_parts, PanelPartsTest)

#include "tst_panel_parts.moc"
