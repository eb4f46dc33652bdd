// The scene of a web page in a real browser: what the window shows besides the bodies can be shown and hidden, and texts and
// numbers are in the language of the page.

#include "tests/suite.h"
#include "tests/web/page_suite.h"

#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace web;

namespace {

constexpr double mostVelocityError = 1e-4; ///< px/frame

/// A foot that swings beside a body that stays. The unit circle shows the arrow from the body to the foot.
QJsonObject spring()
{
    return {{"lesson", "single_spring"}, {"step", "radial"}, {"frames", 60}};
}

/// Returns 60 frames of walker(), with a run beside it whose damping differs from frame 20 on.
QJsonObject walkerWithGhost()
{
    QJsonObject both = walker();
    const QJsonObject change = {{"frame", 20}, {"event", "set"}, {"parameter", "damp"}, {"value", 0.5}};
    both["frames"] = 60;
    both["branches"] = QJsonArray{
        QJsonObject{{"name", "slower"}, {"fork", 20}, {"frames", 60}, {"input", QJsonArray{change}}}};
    return both;
}

/// Returns the numbers of a row of what `trace` has printed: x, y, vx, vy.
QList<double> rowOf(const QByteArray &trace, qint64 frame, const QByteArray &body)
{
    const QByteArray start = '\n' + QByteArray::number(frame) + ',' + body + ',';
    const qsizetype from = trace.indexOf(start) + start.size();
    QList<double> numbers;
    for (const QByteArray &cell : trace.mid(from, trace.indexOf('\n', from) - from).split(','))
        numbers << cell.toDouble();
    return numbers;
}

}

class WebPageSceneTest : public PageSuite
{
    Q_OBJECT

    bool shows(const QString &name) { return m_browser.valueOf("run.painter.shows." + name).toBool(); }
    /// Returns the picture of the scene, once the browser has drawn it.
    QString picture()
    {
        return m_browser
            .valueOf("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => "
                     "done(run.canvas.toDataURL()))))")
            .toString();
    }
    /// Opens the page of walkerWithGhost().
    void openWithGhost()
    {
        if (m_ghostPage.isEmpty())
            m_ghostPage = page(file("ghost", walkerWithGhost()), {"--ghost", "slower"});
        m_browser.open(m_ghostPage);
    }
    QString legend() { return textOf(".legend"); }
    QString textOf(const char *selector)
    {
        return m_browser.valueOf(QString("document.querySelector('%1').innerText").arg(selector)).toString();
    }

    QString m_ghostPage;

private slots:
    void theSceneShowsWhatTheWindowShowsFirst_data();
    void theSceneShowsWhatTheWindowShowsFirst();
    void velocitiesAreThoseOfTrace_data();
    void velocitiesAreThoseOfTrace();
    void theMenuShowsAndHides_data();
    void theMenuShowsAndHides();
    void theMenuIsClosedByEscapeAndByAClickBesideIt();
    void theGhostIsThereWhereItDiffers();
    void theUnitCircleShowsTheAngle();
    void aSmallScreenHasTheUnitCircleBelowTheScene();
    void theSceneIsDrawnAtOnceInAnotherSize();
    void plotsAreThoseAskedFor();
    void textsAndNumbersFollowTheLanguage_data();
    void textsAndNumbersFollowTheLanguage();
};

void WebPageSceneTest::theSceneShowsWhatTheWindowShowsFirst_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<bool>("velocities");
    QTest::addColumn<bool>("onion");
    QTest::newRow("walker") << "walking_gait"
                            << "ground" << false << false;
    QTest::newRow("motor") << "codeling"
                           << "motor" << true << false;
    QTest::newRow("squash and stretch") << "codeling"
                                        << "squash_stretch" << true << true;
}

void WebPageSceneTest::theSceneShowsWhatTheWindowShowsFirst()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(bool, velocities);
    QFETCH(bool, onion);
    m_browser.open(page(file("first", {{"lesson", lesson}, {"step", step}, {"frames", 20}})));
    QCOMPARE(m_browser.complaints(), QList<QString>());
    QVERIFY(shows("trails") && shows("guides") && shows("grid") && shows("eyes"));
    QCOMPARE(shows("velocities"), velocities);
    QCOMPARE(shows("onion"), onion);
}

void WebPageSceneTest::velocitiesAreThoseOfTrace_data()
{
    QTest::addColumn<QJsonObject>("experiment");
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("that move the body") << walker() << QByteArray("body");
    QJsonObject exact = walker();
    exact["method"] = "rk4";
    QTest::newRow("that do not") << exact << QByteArray("body");
    QJsonObject coarse = spring();
    coarse["h"] = 2;
    QTest::newRow("every second frame") << coarse << QByteArray("foot");
}

void WebPageSceneTest::velocitiesAreThoseOfTrace()
{
    QFETCH(QJsonObject, experiment);
    QFETCH(QByteArray, body);
    experiment["frames"] = 60;
    const QString from = file("velocities", experiment);
    const QByteArray trace = springstep({"trace", from});
    m_browser.open(page(from));
    for (const int at : {0, 2, 46}) {
        const QJsonValue shown =
            m_browser.valueOf(QString("run.frame = %1, run.velocityOf('%2')").arg(at).arg(QString(body)));
        const QList<double> expected = rowOf(trace, at, body);
        QCOMPARE(expected.size(), 4);
        const double error =
            std::hypot(shown["x"].toDouble() - expected[2], shown["y"].toDouble() - expected[3]);
        QVERIFY2(shown.isObject() && error <= mostVelocityError,
                 qPrintable(QString("%1 px/frame at frame %2").arg(error).arg(at)));
    }
}

void WebPageSceneTest::theMenuShowsAndHides_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("key");
    QTest::newRow("trails") << "trails"
                            << "t";
    QTest::newRow("velocity arrows") << "velocities"
                                     << "v";
    QTest::newRow("onion skins") << "onion"
                                 << "o";
    QTest::newRow("ghost") << "ghost"
                           << "g";
    QTest::newRow("guide lines") << "guides"
                                 << "l";
}

void WebPageSceneTest::theMenuShowsAndHides()
{
    QFETCH(QString, name);
    QFETCH(QString, key);
    openWithGhost();
    goTo(30);
    const bool was = shows(name);
    const QString before = picture();
    m_browser.click(".show summary");
    const QByteArray box = "input[name=" + name.toUtf8() + ']';
    m_browser.click(box.constData());
    QCOMPARE(shows(name), !was);
    QVERIFY(picture() != before);
    QCOMPARE(legend().contains("px/frame"), shows("velocities"));
    m_browser.press(key);
    QCOMPARE(shows(name), was);
    QCOMPARE(m_browser.valueOf(QString("document.querySelector('%1').checked").arg(QString(box))),
             QJsonValue(was));
    QCOMPARE(picture(), before);
}

void WebPageSceneTest::theMenuIsClosedByEscapeAndByAClickBesideIt()
{
    openWalker();
    const auto isOpen = [this] { return m_browser.valueOf("document.querySelector('.show').open").toBool(); };
    m_browser.valueOf("document.querySelector('.show summary').focus()");
    m_browser.press("Enter");
    QVERIFY(isOpen());
    m_browser.press("Tab");
    m_browser.press("Escape");
    QVERIFY(!isOpen());
    QVERIFY(m_browser.valueOf("document.activeElement === document.querySelector('.show summary')").toBool());
    m_browser.click(".show summary");
    QVERIFY(isOpen());
    m_browser.click("h1");
    QVERIFY(!isOpen());
}

void WebPageSceneTest::theGhostIsThereWhereItDiffers()
{
    openWithGhost();
    QCOMPARE(m_browser.complaints(), QList<QString>());
    goTo(10);
    picture();
    QVERIFY(!legend().contains("slower"));
    goTo(40);
    picture();
    QVERIFY2(legend().contains("slower"), qPrintable(legend()));
    openWalker();
    QCOMPARE(m_browser.valueOf("document.querySelectorAll('input[name=ghost]').length").toInt(), 0);
}

void WebPageSceneTest::theUnitCircleShowsTheAngle()
{
    const QString from = file("circle", spring());
    const QByteArray trace = springstep({"trace", from});
    m_browser.open(page(from));
    for (const int at : {0, 30}) {
        goTo(at);
        picture();
        // The arrow goes from the body to the foot.
        const QList<double> body = rowOf(trace, at, "body"), foot = rowOf(trace, at, "foot");
        const double x = foot[0] - body[0], y = foot[1] - body[1], length = std::hypot(x, y);
        const auto number = [](double value, int digits) {
            return QString::number(value, 'f', digits).replace('-', QChar(0x2212));
        };
        const double angle = std::atan2(y, x);
        const QString text = textOf(".card");
        for (const QString &line :
             {QString("angle = %1°").arg(number(angle * 180.0 / std::numbers::pi, 1)),
              QString("cosine = %1 / %2 = %3").arg(number(x, 1), number(length, 1), number(x / length, 3)),
              QString("sine = %1 / %2 = %3").arg(number(y, 1), number(length, 1), number(y / length, 3))})
            QVERIFY2(text.contains(line), qPrintable(line + '\n' + text));
    }
    m_browser.press("u");
    picture();
    QVERIFY(m_browser.valueOf("document.querySelector('.card').hidden").toBool());
}

void WebPageSceneTest::aSmallScreenHasTheUnitCircleBelowTheScene()
{
    m_browser.open(page(file("small", spring())));
    const auto isBelow = [this] {
        return m_browser
            .valueOf("document.querySelector('.card').getBoundingClientRect().top >= "
                     "document.querySelector('.view').getBoundingClientRect().bottom")
            .toBool();
    };
    QVERIFY(!isBelow());
    m_browser.call("Emulation.setDeviceMetricsOverride",
                   {{"width", 400}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", true}});
    picture();
    QVERIFY(isBelow());
    QVERIFY(m_browser.valueOf("document.documentElement.scrollWidth <= 400").toBool());
    m_browser.call("Emulation.clearDeviceMetricsOverride");
    picture();
    QVERIFY(!isBelow());
}

void WebPageSceneTest::theSceneIsDrawnAtOnceInAnotherSize()
{
    openWalker();
    // The observers are told before the browser paints, that of the page first.
    const char *const isEmpty =
        "new Promise((done) => { document.querySelector('.view').style.maxHeight = '20rem'; "
        "new ResizeObserver(() => { const { data } = run.canvas.getContext('2d').getImageData(0, 0, 50, 50); "
        "done(!data.some((one) => one > 0)); }).observe(run.canvas); })";
    QVERIFY(!m_browser.valueOf(isEmpty).toBool());
}

void WebPageSceneTest::plotsAreThoseAskedFor()
{
    m_browser.open(page(file("plots", walker()), {"--to", "20", "--plot", "y(foot1)", "--plot", "speed",
                                                  "--plot", "velocity_y(body):y(body)"}));
    const QJsonArray titles =
        m_browser
            .valueOf("[...document.querySelectorAll('.plot figcaption span:first-child')].map((one) => "
                     "one.textContent)")
            .toArray();
    QCOMPARE(titles, QJsonArray({"y of foot 1", "speed of foot 0", "velocity y of body – y of body"}));
}

void WebPageSceneTest::textsAndNumbersFollowTheLanguage_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("clock");
    QTest::addColumn<QString>("speed");
    QTest::newRow("English") << "en"
                             << "Frame 30 of 60 1.00 s"
                             << "0.5";
    QTest::newRow("German") << "de"
                            << "Bild 30 von 60 1,00 s"
                            << "0,5";
    QTest::newRow("Spanish") << "es"
                             << "Fotograma 30 de 60 1,00 s"
                             << "0,5";
    QTest::newRow("French") << "fr"
                            << "Image 30 sur 60 1,00 s"
                            << "0,5";
}

void WebPageSceneTest::textsAndNumbersFollowTheLanguage()
{
    QFETCH(QString, language);
    QFETCH(QString, clock);
    QFETCH(QString, speed);
    m_browser.open(page(file("language", spring()), {"--language", language}));
    QCOMPARE(m_browser.valueOf("document.documentElement.lang").toString(), language);
    goTo(30);
    picture();
    const auto plain = [](QString text) {
        return text.replace(QChar(0x202F), ' ').replace(QChar(0xA0), ' ');
    };
    QCOMPARE(plain(textOf(".clock")), clock);
    QVERIFY(m_browser.valueOf("document.querySelector('select').textContent").toString().contains(speed));
    const QString sign = language == "en" ? "." : ",", other = language == "en" ? "," : ".";
    const QString value = textOf(".plot .number"), angle = textOf(".equation");
    QVERIFY2(value.contains(sign) && !value.contains(other), qPrintable(value));
    QVERIFY2(angle.contains(sign) && !angle.contains(other), qPrintable(angle));
}

SUITE(tst_web_page_scene, WebPageSceneTest)
#include "tst_web_page_scene.moc"
