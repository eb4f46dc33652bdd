// Pictures and films of the scene.

#include "app/model/words.h"
#include "app/ui/film/film_dialog.h"
#include "app/ui/film/picture_file.h"
#include "app/ui/panels/ask_file.h"
#include "app/ui/window/attempt.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"

#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>

namespace app {

void MainWindow::makeExportActions()
{
    const KeyGroup group = KeyGroup::pictures;
    QMenu *menu = m_file->addMenu(tr("&Export"));
    const auto add = [&](const QString &text, const char *key, const QString &help, auto slot) {
        QAction *made = m_commands->add(text, {QKeySequence(key)}, group);
        made->setToolTip(tr("%1 (%2)").arg(help, made->shortcut().toString(QKeySequence::NativeText)));
        connect(made, &QAction::triggered, this, slot);
        menu->addAction(made);
    };
    add(tr("&Picture of the scene…"), "Ctrl+Shift+E", tr("The scene as it is shown, as PNG or SVG"),
        &MainWindow::askPicture);
    add(tr("&Film of the run…"), "Ctrl+Shift+F", tr("The run as an animated GIF or a PNG for each frame"),
        &MainWindow::showFilm);
}

void MainWindow::copyPicture()
{
    QGuiApplication::clipboard()->setImage(m_scene->picture(pngScale));
    emit m_session.said(tr("The picture of the scene is copied."));
}

void MainWindow::askPicture()
{
    const QString suggestion = m_session.step().id + ".png";
    const QString path =
        askWhereToSave(this, tr("Picture of the scene"), suggestion, tr("Pictures (*.png *.svg)"));
    if (!path.isEmpty())
        savePictureAs(path);
}

bool MainWindow::savePictureAs(const QString &path)
{
    if (!attempt(*m_notice, tr("Picture not saved: %1"), [&] { savePicture(*m_scene, path); }))
        return false;
    emit m_session.said(tr("Saved as %1.").arg(shownPath(QFileInfo(path).fileName())));
    return true;
}

void MainWindow::showFilm()
{
    if (!m_film)
        m_film = new FilmDialog(m_session, *m_scene, m_theme, this);
    m_film->offer();
}

}
