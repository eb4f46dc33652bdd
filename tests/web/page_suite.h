#pragma once

#include "tests/web/browser.h"

#include <QObject>

namespace web {

/// Runs the program. Returns what it printed; ends the test if it fails.
QByteArray springstep(const QStringList &arguments);

/// Returns an experiment: 600 frames of the creature that walks on the ground.
QJsonObject walker();

/// A suite about web pages of runs, with a folder for the pages and a browser that shows them.
class PageSuite : public QObject
{
protected:
    /// Makes the page of walker().
    PageSuite();

    /// Writes an experiment. Returns its file.
    QString file(const QString &name, QJsonObject experiment);
    /// Makes the page of an experiment. Returns its file.
    QString page(const QString &experiment, const QStringList &options = {});
    /// Returns the page of walker(), a file.
    const QString &walkerPage() const { return m_walkerPage; }
    void openWalker() { m_browser.open(m_walkerPage); }

    qint64 frame() { return m_browser.valueOf("run.frame").toInteger(); }
    void goTo(int frame) { m_browser.valueOf(QString("run.frame = %1").arg(frame)); }

    QTemporaryDir m_folder;
    Browser m_browser;

private:
    QString m_walkerPage;
};

}
