// Experiments as files: opening, saving, and the name of the one that is open.

#include "app/model/sentences.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QFileDialog>
#include <QFileInfo>

namespace app {

void MainWindow::nameWindow()
{
    const QString name = m_path.isEmpty() ? m_session.step().title : QFileInfo(m_path).fileName();
    setWindowTitle(tr("%1 – Springstep").arg(name));
}

void MainWindow::openFile(const QString &path)
{
    try {
        m_session.open(readExperiment(path, m_session.library()));
        m_path = path;
        m_notice->say({});
        nameWindow();
    } catch (const Refusal &refusal) {
        m_notice->say(tr("Experiment not opened: %1 Your scene is unchanged.").arg(refusal.sentence()));
    } catch (const sim::Error &error) {
        m_notice->say(tr("Experiment not opened: %1 Your scene is unchanged.").arg(sentenceFor(error)));
    }
}

bool MainWindow::saveFile(const QString &path)
{
    try {
        writeExperiment(path, m_session.experiment(), m_session.library());
    } catch (const Refusal &refusal) {
        m_notice->say(tr("Experiment not saved: %1").arg(refusal.sentence()));
        return false;
    }
    m_path = path;
    nameWindow();
    emit m_session.said(tr("Saved as %1.").arg(QFileInfo(path).fileName()));
    return true;
}

void MainWindow::askOpen()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open an experiment"), m_path, tr("Experiments (*.json)"));
    if (!path.isEmpty())
        openFile(path);
}

void MainWindow::askSave()
{
    const QString suggestion = m_path.isEmpty() ? m_session.step().id + ".json" : m_path;
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the experiment"), suggestion, tr("Experiments (*.json)"));
    if (!path.isEmpty())
        saveFile(path);
}

}
