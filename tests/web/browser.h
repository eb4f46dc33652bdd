#pragma once

#include <QHash>
#include <QJsonObject>
#include <QList>
#include <QPointF>
#include <QProcess>
#include <QSocketNotifier>
#include <QString>
#include <QTemporaryDir>

#include <memory>

namespace web {

/// A page in Chromium, without a screen. Messages of the DevTools protocol go through two pipes: each is JSON with a 0 at
/// its end (--remote-debugging-pipe), so that no network is used.
class Browser
{
public:
    /// Starts the program. Ends the test if it does not start.
    Browser();
    ~Browser();

    /// Opens a file, and waits until its run is shown.
    void open(const QString &file);
    /// Sends a message, and returns its result.
    QJsonObject call(const QString &method, const QJsonObject &parameters = {});
    /// Returns the value of an expression of JavaScript. A promise is waited for.
    QJsonValue valueOf(const QString &expression);
    /// Waits until an expression is true, looking at every picture. Returns whether it became true.
    bool waitFor(const QString &expression);

    /// Returns the middle of the element that a selector finds, px of the window.
    QPointF middleOf(const QString &selector);
    void click(QPointF at);
    void click(const char *selector) { click(middleOf(selector)); }
    void drag(QPointF from, QPointF to);
    void turnWheel(QPointF at, double by);
    /// Presses a key and lets it go. `name` is that of KeyboardEvent.key. Of `modifiers`, 1 is Alt, 2 Ctrl and 8 Shift.
    void press(const QString &name, int modifiers = 0);

    /// Returns the addresses that the page has asked for since it was opened, besides itself and data in its own text.
    const QList<QString> &requests() const { return m_requests; }
    /// Returns the errors and warnings that the browser has noted since then.
    const QList<QString> &complaints() const { return m_complaints; }

private:
    void read();
    void take(const QJsonObject &message);
    void sendMouse(const QString &type, QPointF at, const QJsonObject &more = {});

    QTemporaryDir m_profile;
    QProcess m_process;
    int m_in = -1;  ///< of the browser
    int m_out = -1; ///< likewise
    std::unique_ptr<QSocketNotifier> m_notifier;
    QByteArray m_buffer;
    int m_last = 0;    ///< id of the last message
    QString m_session; ///< of the page
    QHash<int, QJsonObject> m_answers;
    QString m_address;
    QList<QString> m_requests;
    QList<QString> m_complaints;
};

}
