// The web page of a run in a real browser: every control works by mouse and by keys.

#include "tests/suite.h"
#include "tests/web/page_suite.h"

#include <QJsonArray>
#include <QTest>

#include <cmath>

using namespace web;

namespace {

constexpr int ctrl = 2, shift = 8;

}

class WebPageControlsTest : public PageSuite
{
    Q_OBJECT

    double zoom() { return m_browser.valueOf("run.zoom").toDouble(); }
    /// Returns where the origin of the scene is on the screen.
    QPointF origin()
    {
        const QJsonValue place = m_browser.valueOf("run.placeOnScreen(0, 0)");
        return {place["x"].toDouble(), place["y"].toDouble()};
    }
    bool isPlaying() { return m_browser.valueOf("run.isPlaying").toBool(); }

private slots:
    void buttonsMoveTime();
    void playRunsToTheEnd();
    void theSliderScrubs();
    void theViewIsDraggedAndZoomed();
    void keysMoveTime();
    void keysMoveTheView();
    void everyControlIsReachedByTab();
    void aPlotIsScrubbed();
    void theSwitchChangesTheColours();
};

void WebPageControlsTest::buttonsMoveTime()
{
    openWalker();
    QCOMPARE(frame(), 0);
    m_browser.click("button[name=forward]");
    m_browser.click("button[name=forward]");
    QCOMPARE(frame(), 2);
    QVERIFY(m_browser.waitFor("document.querySelector('.clock').textContent.startsWith('Frame 2 of 600')"));
    m_browser.click("button[name=back]");
    QCOMPARE(frame(), 1);
    m_browser.click("button[name=start]");
    QCOMPARE(frame(), 0);
    m_browser.click("button.play");
    QVERIFY(isPlaying());
    QVERIFY(m_browser.waitFor("run.frame > 3"));
    m_browser.click("button.play");
    QVERIFY(!isPlaying());
}

void WebPageControlsTest::playRunsToTheEnd()
{
    openWalker();
    goTo(590);
    m_browser.valueOf("const box = document.querySelector('select'); box.value = '4'; "
                      "box.dispatchEvent(new Event('change')); true");
    m_browser.click("button.play");
    QVERIFY(m_browser.waitFor("run.frame === 600 && !run.isPlaying"));
    m_browser.click("button.play"); // begins again
    QVERIFY(m_browser.waitFor("run.isPlaying && run.frame > 0 && run.frame < 590"));
    m_browser.click("button.play");
}

void WebPageControlsTest::theSliderScrubs()
{
    openWalker();
    const QPointF middle = m_browser.middleOf("input[type=range]");
    m_browser.click(middle);
    QVERIFY(std::abs(frame() - 300) <= 5);
    m_browser.drag(middle, middle - QPointF(60.0, 0.0));
    QVERIFY(frame() < 290);
    QCOMPARE(m_browser.valueOf("document.querySelector('input[type=range]').getAttribute('aria-label')"),
             QJsonValue("Frame"));
    goTo(30);
    QVERIFY(
        m_browser.waitFor("document.querySelector('input[type=range]').getAttribute('aria-valuetext') === "
                          "'Frame 30 of 600, 1.00 s'"));
}

void WebPageControlsTest::theViewIsDraggedAndZoomed()
{
    openWalker();
    const QPointF middle = m_browser.middleOf(".view canvas");
    const QPointF before = origin();
    m_browser.drag(middle, middle + QPointF(50.0, -20.0));
    QCOMPARE(origin() - before, QPointF(50.0, -20.0));
    const double was = zoom();
    m_browser.turnWheel(middle, -120.0);
    QVERIFY(m_browser.waitFor(QString("run.zoom > 1.2 * %1").arg(was)));
    m_browser.click("button[name=zoomOut]");
    QVERIFY(std::abs(zoom() - was) < 1e-9);
    m_browser.click("button[name=zoomIn]");
    QVERIFY(zoom() > 1.2 * was);
    m_browser.click("button[name=fit]");
    QVERIFY(std::abs(zoom() - was) < 1e-9);
    QCOMPARE(origin(), before);
}

void WebPageControlsTest::keysMoveTime()
{
    openWalker();
    m_browser.press("ArrowRight");
    QCOMPARE(frame(), 1);
    m_browser.press("ArrowRight", ctrl);
    QCOMPARE(frame(), 11);
    m_browser.press("ArrowLeft");
    QCOMPARE(frame(), 10);
    m_browser.press("End");
    QCOMPARE(frame(), 600);
    m_browser.press("Home");
    QCOMPARE(frame(), 0);
    m_browser.press(" ");
    QVERIFY(isPlaying());
    QVERIFY(m_browser.waitFor("run.frame > 3"));
    m_browser.press(" ");
    QVERIFY(!isPlaying());
    m_browser.valueOf("document.querySelector('input[type=range]').focus()");
    const qint64 was = frame();
    m_browser.press("ArrowRight");
    QCOMPARE(frame(), was + 1);
}

void WebPageControlsTest::keysMoveTheView()
{
    openWalker();
    const QPointF before = origin();
    const double was = zoom();
    m_browser.press("ArrowRight", shift);
    QVERIFY(origin().x() < before.x());
    m_browser.press("+");
    QVERIFY(zoom() > was);
    m_browser.press("-");
    QVERIFY(std::abs(zoom() - was) < 1e-9);
    m_browser.press("0");
    QCOMPARE(origin(), before);
}

void WebPageControlsTest::everyControlIsReachedByTab()
{
    openWalker();
    m_browser.valueOf("document.querySelector('.show').open = true");
    const int controls =
        m_browser.valueOf("document.querySelectorAll('button, input, select, summary, .view canvas').length")
            .toInt();
    const int nameless =
        m_browser
            .valueOf("[...document.querySelectorAll('button, input, select, canvas')].filter("
                     "(one) => !one.getAttribute('aria-label')).length")
            .toInt();
    QCOMPARE(nameless, 0);
    m_browser.valueOf("window.seen = new Set(); document.addEventListener('focusin', (event) => { "
                      "if (event.target.matches('button, input, select, summary, .view canvas')) "
                      "seen.add(event.target); }), true");
    for (int i = 0; i < controls + 5; ++i)
        m_browser.press("Tab");
    QCOMPARE(m_browser.valueOf("seen.size").toInt(), controls);
    // A button with the focus takes Space and Enter itself.
    m_browser.valueOf("document.querySelector('button[name=forward]').focus()");
    const qint64 was = frame();
    m_browser.press(" ");
    m_browser.press("Enter");
    QCOMPARE(frame(), was + 2);
}

void WebPageControlsTest::aPlotIsScrubbed()
{
    openWalker();
    QCOMPARE(m_browser.valueOf("document.querySelectorAll('.plot').length").toInt(), 1);
    m_browser.click(".plot canvas");
    QVERIFY(frame() > 200 && frame() < 400);
    QVERIFY(m_browser.waitFor("document.querySelector('.plot .number').textContent.endsWith('px')"));
}

void WebPageControlsTest::theSwitchChangesTheColours()
{
    const auto background = [this] {
        return m_browser.valueOf("getComputedStyle(document.documentElement).backgroundColor").toString();
    };
    const auto prefer = [this](const char *scheme) {
        const QJsonObject feature = {{"name", "prefers-color-scheme"}, {"value", scheme}};
        m_browser.call("Emulation.setEmulatedMedia", {{"features", QJsonArray{feature}}});
    };
    prefer("light");
    openWalker();
    const QString light = background();
    prefer("dark");
    const QString dark = background();
    QVERIFY(light != dark);
    m_browser.click("header button");
    QCOMPARE(background(), light);
    QVERIFY(!m_browser.valueOf("run.painter.isDark").toBool());
    m_browser.press("c");
    QCOMPARE(background(), dark);
    prefer("light");
    QCOMPARE(background(), dark); // as the reader chose
}

SUITE(tst_web_page_controls, WebPageControlsTest)
#include "tst_web_page_controls.moc"
