// `springstep film FILE OUT.html` and its page in a real browser: the positions are those of `trace`, the page has the
// texts of the step, no text of an experiment runs, and nothing is loaded.

#include "tests/suite.h"
#include "tests/web/page_suite.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QTest>
#include <QUrl>

#include <algorithm>
#include <cmath>

using namespace web;

namespace {

constexpr double mostError = 1e-6; ///< px
constexpr qint64 mostBytes = 500'000;
constexpr int rateFrames = 90; ///< pictures, to measure the frame rate

/// A row of `trace`.
struct Place
{
    qint64 frame = 0;
    QString body;
    double x = 0.0, y = 0.0;
};

QList<Place> traceOf(const QString &file)
{
    QList<Place> places;
    for (const QByteArray &line : springstep({"trace", file}).split('\n').mid(1)) {
        const QList<QByteArray> cells = line.split(',');
        if (cells.size() >= 4)
            places.append({cells[0].toLongLong(), cells[1], cells[2].toDouble(), cells[3].toDouble()});
    }
    return places;
}

/// A net of 200 bodies with springs that falls on the floor.
QJsonObject net()
{
    constexpr int across = 20, down = 10;
    QJsonObject bodies;
    QJsonArray springs;
    const auto name = [](int x, int y) { return QString("p%1_%2").arg(x).arg(y); };
    for (int y = 0; y < down; ++y) {
        for (int x = 0; x < across; ++x) {
            bodies[name(x, y)] = QJsonObject{{"x", 80 + 20 * x}, {"y", 40 + 20 * y}, {"size", 12}};
            if (x > 0)
                springs << QJsonObject{{"a", name(x - 1, y)}, {"b", name(x, y)}, {"k", 0.2}, {"length", 20}};
            if (y > 0)
                springs << QJsonObject{{"a", name(x, y - 1)}, {"b", name(x, y)}, {"k", 0.2}, {"length", 20}};
        }
    }
    return {{"lesson", "sandbox"},
            {"step", "build"},
            {"frames", 200},
            {"scene", QJsonObject{{"bodies", bodies},
                                  {"springs", springs},
                                  {"sticks", QJsonArray()},
                                  {"gaits", QJsonArray()},
                                  {"feet", QJsonArray()},
                                  {"effects", QJsonArray{"gravity", "damping", "walls"}}}}};
}

}

class WebPageTest : public PageSuite
{
    Q_OBJECT

private slots:
    void aPageOfTheWalkerIsSmall();
    void positionsAreThoseOfTrace_data();
    void positionsAreThoseOfTrace();
    void thePageBeginsWhereItIsTold();
    void theListingShowsTheValuesOfTheFrame();
    void titleAndTextAreThere();
    void noTextOfAnExperimentRuns();
    void nothingIsLoaded();
    void aDamagedPageSaysSo();
    void twoHundredBodiesAreDrawn();
    void onionSkinsOfACrowdAreDrawnOnce();
};

void WebPageTest::aPageOfTheWalkerIsSmall()
{
    const qint64 size = QFileInfo(walkerPage()).size();
    qInfo("%lld bytes for 600 frames of the walker", static_cast<long long>(size));
    QVERIFY(size < mostBytes);
}

void WebPageTest::positionsAreThoseOfTrace_data()
{
    QTest::addColumn<QJsonObject>("experiment");
    QTest::newRow("walker") << walker();
    QTest::newRow("tree") << QJsonObject{{"lesson", "swaying_tree"}, {"step", "branches"}, {"frames", 40}};
    QTest::newRow("steps of two frames")
        << QJsonObject{{"lesson", "multi_foot"}, {"step", "any_number"}, {"h", 2}, {"frames", 60}};
    const QJsonObject more = {{"frame", 20}, {"event", "set"}, {"parameter", "feet"}, {"value", 9}};
    QTest::newRow("feet are added") << QJsonObject{
        {"lesson", "multi_foot"}, {"step", "any_number"}, {"frames", 60}, {"input", QJsonArray{more}}};
    const QJsonObject far = {{"x", 1e12}, {"y", -3e15}};
    QTest::newRow("far away") << QJsonObject{{"lesson", "single_spring"},
                                             {"step", "radial"},
                                             {"frames", 30},
                                             {"bodies", QJsonObject{{"foot", far}}}};
}

void WebPageTest::positionsAreThoseOfTrace()
{
    QFETCH(QJsonObject, experiment);
    const QString from = file("run", experiment);
    const QList<Place> places = traceOf(from);
    QVERIFY(!places.isEmpty());
    m_browser.open(page(from));
    QCOMPARE(m_browser.complaints(), QList<QString>());
    const qint64 last = places.last().frame;
    QCOMPARE(m_browser.valueOf("run.frame = 1e9, run.frame").toInteger(), last);
    const QList<qint64> frames = {0, places[places.size() / 3].frame, places[places.size() / 2].frame, last};
    for (const qint64 at : frames) {
        const QJsonValue shown =
            m_browser.valueOf(QString("(() => { run.frame = %1; return Object.fromEntries(run.bodies.map("
                                      "(body) => [body, run.positionOf(body)])); })()")
                                  .arg(at));
        for (const Place &place : places) {
            if (place.frame != at)
                continue;
            const QJsonValue here = shown[place.body];
            const double error = std::hypot(here["x"].toDouble() - place.x, here["y"].toDouble() - place.y);
            QVERIFY2(here.isObject() && error <= mostError,
                     qPrintable(QString("%1 at frame %2 is %3 px off").arg(place.body).arg(at).arg(error)));
        }
    }
}

void WebPageTest::thePageBeginsWhereItIsTold()
{
    const QString from = file("part", walker());
    const QList<Place> places = traceOf(from);
    m_browser.open(page(from, {"--from", "40", "--to", "70"}));
    QCOMPARE(frame(), 40);
    QCOMPARE(m_browser.valueOf("run.count").toInt(), 31);
    const auto place = std::find_if(places.begin(), places.end(),
                                    [](const Place &one) { return one.frame == 40 && one.body == "body"; });
    QVERIFY(std::abs(m_browser.valueOf("run.positionOf('body').x").toDouble() - place->x) <= mostError);
}

void WebPageTest::theListingShowsTheValuesOfTheFrame()
{
    const QString code =
        "void frame()\n{\n    double number = 2.0 * frame_number;\n    body.position.x += 1.5;\n}\n";
    m_browser.open(page(file("listing", {{"lesson", "walking_gait"},
                                         {"step", "ground"},
                                         {"frames", 20},
                                         {"method", "listing"},
                                         {"code", code}})));
    QCOMPARE(m_browser.complaints(), QList<QString>());
    goTo(0);
    QCOMPARE(m_browser.valueOf("run.valueAt(3)").toString(), QString());
    goTo(6);
    QCOMPARE(m_browser.valueOf("run.valueAt(3)").toString(), QString("number = 12.0"));
    QVERIFY(m_browser.waitFor(
        "document.querySelectorAll('.listing li')[2].querySelector('.value').textContent === "
        "'number = 12.0'"));
    QVERIFY(m_browser.valueOf("document.querySelectorAll('.listing li')[2].classList.contains('changed')")
                .toBool());
    QCOMPARE(m_browser.valueOf("document.querySelectorAll('.listing code')[3].textContent").toString(),
             QString("    body.position.x += 1.5;"));
    openWalker(); // a built-in method, with the step's own listing
    goTo(50);
    QVERIFY(
        m_browser.waitFor("[...document.querySelectorAll('.value')].some((one) => one.textContent !== '')"));
}

void WebPageTest::titleAndTextAreThere()
{
    openWalker();
    QCOMPARE(m_browser.valueOf("document.title").toString(),
             QString("%1 – Walking")
                 .arg(m_browser.valueOf("document.querySelector('h1').textContent").toString()));
    QCOMPARE(m_browser.valueOf("document.documentElement.lang").toString(), QString("en"));
    QVERIFY(
        m_browser.valueOf("document.querySelector('.prose').textContent.includes('Press Space and watch')")
            .toBool());
    QVERIFY(m_browser.valueOf("document.querySelectorAll('.prose strong').length").toInt() > 0);
}

void WebPageTest::noTextOfAnExperimentRuns()
{
    const QString nasty =
        "</script><script>window.hacked = 1</script><img src=x onerror='window.hacked = 2'>";
    const QString code = "// " + nasty + "\nvoid frame()\n{\n    body.position.x += 1.0;\n}\n";
    QJsonObject experiment = {{"lesson", "walking_gait"},
                              {"step", "ground"},
                              {"frames", 10},
                              {"method", "listing"},
                              {"code", code},
                              {"name", nasty},
                              {"named", true}};
    m_browser.open(page(file("nasty", experiment)));
    QVERIFY(m_browser.waitFor("document.querySelector('.listing code').textContent.includes('onerror')"));
    QVERIFY(
        m_browser.valueOf("document.querySelector('header').textContent.includes('window.hacked')").toBool());
    QVERIFY(m_browser.valueOf("window.hacked === undefined").toBool());
    QCOMPARE(m_browser.valueOf("document.images.length").toInt(), 0);
    QCOMPARE(m_browser.requests(), QList<QString>());
    // Nor could a script run that got in by some other way.
    m_browser.valueOf(
        "const script = document.createElement('script'); script.textContent = 'window.hacked = 3'; "
        "document.body.append(script); true");
    QVERIFY(m_browser.valueOf("window.hacked === undefined").toBool());
}

void WebPageTest::nothingIsLoaded()
{
    openWalker();
    m_browser.press("End");
    QVERIFY(m_browser.waitFor("document.querySelector('.clock').textContent.startsWith('Frame 600')"));
    QCOMPARE(m_browser.requests(), QList<QString>());
    QCOMPARE(m_browser.complaints(), QList<QString>());
}

void WebPageTest::aDamagedPageSaysSo()
{
    QFile whole(walkerPage());
    QVERIFY(whole.open(QFile::ReadOnly));
    QByteArray text = whole.readAll();
    const qsizetype data = text.indexOf("id=\"run\">");
    text.remove(data + 200, 300);
    QFile half(m_folder.filePath("half.html"));
    QVERIFY(half.open(QFile::WriteOnly));
    half.write(text);
    half.close();
    m_browser.call("Page.navigate", {{"url", QUrl::fromLocalFile(half.fileName()).toString()}});
    QVERIFY(m_browser.waitFor("document.querySelector('.message')?.textContent.includes('damaged')"));
}

void WebPageTest::twoHundredBodiesAreDrawn()
{
    const QString from = file("net", net());
    const QString out = page(from);
    qInfo("%lld bytes for 200 frames of 200 bodies", static_cast<long long>(QFileInfo(out).size()));
    m_browser.open(out);
    QCOMPARE(m_browser.complaints(), QList<QString>());
    QCOMPARE(m_browser.valueOf("run.bodies.length").toInt(), 200);
    const QString measure =
        "new Promise((done) => { run.play(); let left = %1, drawn = 0; const draw = run.painter.draw; "
        "run.painter.draw = (index) => { const start = performance.now(); draw.call(run.painter, index); "
        "drawn += performance.now() - start; }; const start = performance.now(); const next = () => { "
        "if (--left > 0) requestAnimationFrame(next); else { run.pause(); "
        "done({rate: %1000 / (performance.now() - start), drawn: drawn / run.frame}); } }; "
        "requestAnimationFrame(next); })";
    const QJsonValue result = m_browser.valueOf(QString(measure).replace("%1", QString::number(rateFrames)));
    qInfo("%.0f pictures a second with 200 bodies; drawing one takes %.2f ms", result["rate"].toDouble(),
          result["drawn"].toDouble());
    QVERIFY(result["rate"].toDouble() > 0.0);
}

void WebPageTest::onionSkinsOfACrowdAreDrawnOnce()
{
    m_browser.open(page(file("skins", net()), {"--to", "60"}));
    m_browser.valueOf(
        "window.counted = (index, onion) => { const { painter } = run; painter.shows.onion = onion; "
        "const canvas = CanvasRenderingContext2D.prototype; const { stroke } = canvas; let count = 0; "
        "canvas.stroke = function(...all) { ++count; stroke.apply(this, all); }; painter.draw(index); "
        "canvas.stroke = stroke; return count; }, true");
    const auto counted = [this](int frame, bool onion) {
        return m_browser.valueOf(QString("counted(%1, %2)").arg(frame).arg(onion ? "true" : "false")).toInt();
    };
    const auto picture = [this] { return m_browser.valueOf("run.canvas.toDataURL()").toString(); };
    counted(41, false);
    const int without = counted(42, false);
    const QString bare = picture();
    counted(41, true);
    QCOMPARE(counted(42, true), without); // the skins have been drawn in frame 41
    QVERIFY(picture() != bare);
    constexpr int links = 20 * 9 + 19 * 10;                  // of net()
    QCOMPARE(counted(45, true) - counted(45, false), links); // one new skin
    m_browser.valueOf("run.painter.camera.pan(10, 0)");
    QVERIFY(counted(46, true) - counted(46, false) >= 6 * links); // the view has moved
}

SUITE(tst_web_page, WebPageTest)
#include "tst_web_page.moc"
