#include "tests/web/browser.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>
#include <QUrl>

#include <fcntl.h>
#include <unistd.h>

#include <array>

namespace web {

namespace {

constexpr int mostWait = 60'000; ///< ms
constexpr int lowestFree = 10;   ///< the browser reads from 3 and writes to 4

/// Returns a pipe whose ends are not among the first few file descriptors.
std::array<int, 2> makePipe()
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        qFatal("There is no pipe for the browser.");
    for (int &end : ends) {
        const int higher = fcntl(end, F_DUPFD_CLOEXEC, lowestFree);
        close(end);
        end = higher;
    }
    return ends;
}

QStringList flags(const QString &profile)
{
    return {"--headless=new",
            "--remote-debugging-pipe",
            "--user-data-dir=" + profile,
            "--window-size=1280,900",
            "--force-device-scale-factor=1",
            "--hide-scrollbars",
            "--no-first-run",
            "--no-sandbox", // containers and root have none, and the pages are ours
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-extensions",
            "--lang=en",
            "about:blank"};
}

}

Browser::Browser()
{
    const std::array<int, 2> in = makePipe(), out = makePipe();
    m_process.setChildProcessModifier([in, out] {
        dup2(in[0], 3);
        dup2(out[1], 4);
    });
    m_process.setStandardErrorFile(QProcess::nullDevice());
    m_process.setStandardOutputFile(QProcess::nullDevice());
    m_process.start(CHROMIUM, flags(m_profile.path()));
    if (!m_process.waitForStarted(mostWait))
        qFatal("Chromium does not start: is the package chromium installed?");
    close(in[0]);
    close(out[1]);
    m_in = in[1];
    m_out = out[0];
    fcntl(m_out, F_SETFL, O_NONBLOCK);
    m_notifier = std::make_unique<QSocketNotifier>(m_out, QSocketNotifier::Read);
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, [this] { read(); });
    QString page;
    const QJsonArray targets = call("Target.getTargets")["targetInfos"].toArray();
    for (const QJsonValue &target : targets) {
        if (target["type"].toString() == "page")
            page = target["targetId"].toString();
    }
    m_session =
        call("Target.attachToTarget", {{"targetId", page}, {"flatten", true}})["sessionId"].toString();
    for (const char *domain : {"Page.enable", "Runtime.enable", "Log.enable", "Network.enable"})
        call(domain);
}

Browser::~Browser()
{
    m_notifier.reset();
    close(m_in); // which ends the browser
    if (!m_process.waitForFinished(mostWait))
        m_process.kill();
    m_process.waitForFinished();
    close(m_out);
}

void Browser::read()
{
    std::array<char, 65536> bytes;
    ssize_t count = 0;
    while ((count = ::read(m_out, bytes.data(), bytes.size())) > 0)
        m_buffer.append(bytes.data(), static_cast<qsizetype>(count));
    if (count == 0)
        m_notifier->setEnabled(false);
    qsizetype end = 0;
    while ((end = m_buffer.indexOf('\0')) >= 0) {
        take(QJsonDocument::fromJson(m_buffer.left(end)).object());
        m_buffer.remove(0, end + 1);
    }
}

void Browser::take(const QJsonObject &message)
{
    if (message.contains("id")) {
        m_answers.insert(message["id"].toInt(), message);
        return;
    }
    const QString method = message["method"].toString();
    const QJsonValue what = message["params"];
    if (method == "Network.requestWillBeSent") {
        const QString address = what["request"]["url"].toString();
        if (address != m_address && !address.startsWith("data:"))
            m_requests << address;
    } else if (method == "Runtime.exceptionThrown") {
        m_complaints << what["exceptionDetails"]["exception"]["description"].toString();
    } else if (method == "Log.entryAdded") {
        m_complaints << what["entry"]["text"].toString();
    }
}

QJsonObject Browser::call(const QString &method, const QJsonObject &parameters)
{
    QJsonObject message = {{"id", ++m_last}, {"method", method}, {"params", parameters}};
    if (!m_session.isEmpty())
        message["sessionId"] = m_session;
    const QByteArray text = QJsonDocument(message).toJson(QJsonDocument::Compact) + '\0';
    if (write(m_in, text.constData(), static_cast<std::size_t>(text.size())) != text.size())
        qFatal("The browser takes no messages.");
    const int id = m_last;
    if (!QTest::qWaitFor([&] { return m_answers.contains(id); }, mostWait))
        qFatal("The browser does not answer to %s.", qPrintable(method));
    const QJsonObject answer = m_answers.take(id);
    if (answer.contains("error"))
        qFatal("%s: %s", qPrintable(method), qPrintable(answer["error"]["message"].toString()));
    return answer["result"].toObject();
}

void Browser::open(const QString &file)
{
    m_requests.clear();
    m_complaints.clear();
    m_address = QUrl::fromLocalFile(file).toString(QUrl::FullyEncoded);
    call("Page.navigate", {{"url", m_address}});
    if (!waitFor("document.querySelector('springstep-run')?.hasAttribute('ready')"))
        qFatal("The page does not show its run: %s", qPrintable(QStringList(m_complaints).join("; ")));
    valueOf("window.run = document.querySelector('springstep-run'), true");
}

QJsonValue Browser::valueOf(const QString &expression)
{
    const QJsonObject result = call(
        "Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
    if (result.contains("exceptionDetails"))
        qFatal("%s: %s", qPrintable(expression),
               qPrintable(result["exceptionDetails"]["exception"]["description"].toString()));
    return result["result"]["value"];
}

bool Browser::waitFor(const QString &expression)
{
    const QString look =
        "new Promise((done) => { const end = performance.now() + 20000; const look = () => { "
        "if (%1) done(true); else if (performance.now() > end) done(false); else "
        "requestAnimationFrame(look); }; look(); })";
    return valueOf(look.arg(expression)).toBool();
}

QPointF Browser::middleOf(const QString &selector)
{
    const QJsonValue box =
        valueOf(QString("(() => { const element = document.querySelector('%1'); "
                        "element.scrollIntoView({block: 'nearest'}); "
                        "const box = element.getBoundingClientRect(); return {x: box.left + box.width / 2, "
                        "y: box.top + box.height / 2}; })()")
                    .arg(selector));
    return {box["x"].toDouble(), box["y"].toDouble()};
}

void Browser::sendMouse(const QString &type, QPointF at, const QJsonObject &more)
{
    QJsonObject event = {{"type", type}, {"x", at.x()}, {"y", at.y()}};
    for (auto it = more.begin(); it != more.end(); ++it)
        event.insert(it.key(), it.value());
    call("Input.dispatchMouseEvent", event);
}

void Browser::click(QPointF at)
{
    sendMouse("mouseMoved", at);
    sendMouse("mousePressed", at, {{"button", "left"}, {"buttons", 1}, {"clickCount", 1}});
    sendMouse("mouseReleased", at, {{"button", "left"}, {"clickCount", 1}});
}

void Browser::drag(QPointF from, QPointF to)
{
    sendMouse("mouseMoved", from);
    sendMouse("mousePressed", from, {{"button", "left"}, {"buttons", 1}, {"clickCount", 1}});
    for (const double share : {0.5, 1.0})
        sendMouse("mouseMoved", from + share * (to - from), {{"button", "left"}, {"buttons", 1}});
    sendMouse("mouseReleased", to, {{"button", "left"}, {"clickCount", 1}});
}

void Browser::turnWheel(QPointF at, double by)
{
    sendMouse("mouseWheel", at, {{"deltaX", 0}, {"deltaY", by}});
}

void Browser::press(const QString &name, int modifiers)
{
    static const QHash<QString, int> codes = {
        {" ", 32},          {"End", 35},       {"Home", 36}, {"ArrowLeft", 37}, {"ArrowUp", 38},
        {"ArrowRight", 39}, {"ArrowDown", 40}, {"Tab", 9},   {"Enter", 13},     {"Escape", 27}};
    QJsonObject event = {{"type", "keyDown"},
                         {"key", name},
                         {"modifiers", modifiers},
                         {"windowsVirtualKeyCode", codes.value(name, name[0].toUpper().unicode())}};
    if (name.size() == 1)
        event["text"] = name;
    if (name == "Enter")
        event["text"] = "\r";
    call("Input.dispatchKeyEvent", event);
    event["type"] = "keyUp";
    event.remove("text");
    call("Input.dispatchKeyEvent", event);
}

}
