// What helps to learn, besides the lessons: hints, the glossary, and the tour.

#include "app/ui/code/code_panel.h"
#include "app/ui/panels/about_page.h"
#include "app/ui/panels/glossary_page.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/narration.h"
#include "app/ui/panels/parameter_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/tour.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>

namespace app {

namespace {

const char *const tourSeen = "tour/seen";

}

void MainWindow::makeLearning()
{
    QAction *hint = m_commands->add(tr("Show a &hint"), {QKeySequence(Qt::Key_H)}, KeyGroup::steps);
    hint->setToolTip(tr("A hint for the next thing to try (H)"));
    connect(hint, &QAction::triggered, this, [this] {
        m_left->show();
        m_learn->setForm(LearnPanel::Form::whole);
        m_learn->showSummary(false);
        m_learn->narration().showNextHint();
    });
    QAction *glossary = m_commands->add(
        tr("&Glossary"), {QKeySequence("Shift+F1"), QKeySequence("Ctrl+Shift+G")}, KeyGroup::window);
    glossary->setToolTip(tr("The words that the lessons teach (Shift+F1)"));
    connect(glossary, &QAction::triggered, this, [this] { showGlossary({}); });
    QAction *tour = m_commands->add(tr("Take the &tour"), {}, KeyGroup::window);
    tour->setToolTip(tr("A minute with what there is in this window"));
    connect(tour, &QAction::triggered, this, &MainWindow::startTour);
    QAction *about = m_commands->add(tr("&About Springstep"), {}, KeyGroup::window);
    about->setMenuRole(QAction::AboutRole);
    about->setToolTip(tr("Version, licence, and what it is built with"));
    connect(about, &QAction::triggered, this, [this] {
        if (!m_about)
            m_about = new AboutPage(m_theme, this);
        m_about->open();
    });
    m_help->addActions({hint, glossary, tour});
    m_help->addSeparator();
    m_help->addAction(about);
    connect(m_learn, &LearnPanel::glossaryAsked, this, &MainWindow::showGlossary);
}

void MainWindow::showGlossary(const QString &typed)
{
    if (!m_glossaryPage) {
        m_glossaryPage = new GlossaryPage(m_learn->glossary(), m_theme, this);
        connect(m_glossaryPage, &GlossaryPage::stepAsked, &m_session, &Session::openStep);
    }
    m_glossaryPage->search(typed);
}

bool MainWindow::wantsTour()
{
    return !QSettings().value(tourSeen).toBool();
}

void MainWindow::startTour()
{
    setMode(Mode::learn);
    for (QDockWidget *dock : {m_left, m_codeDock, m_parameterDock})
        dock->show();
    m_learn->setForm(LearnPanel::Form::whole);
    if (!m_tour) {
        m_tour = new Tour(tourStops(), m_theme, this);
        connect(m_tour, &Tour::ended, m_scene, qOverload<>(&QWidget::setFocus));
    }
    m_tour->start();
    QSettings().setValue(tourSeen, true);
}

std::vector<TourStop> MainWindow::tourStops()
{
    const auto whole = [this](const QWidget *widget) {
        return [this, widget] { return QRect(widget->mapTo(this, QPoint()), widget->size()); };
    };
    const auto half = [this](bool upper) {
        return [this, upper] {
            QRect part(m_timeline->mapTo(this, QPoint()), m_timeline->size());
            part.setHeight(part.height() / 2);
            return upper ? part : part.translated(0, part.height());
        };
    };
    const QWidget *tries = m_learn->findChild<QWidget *>("tries");
    return {
        {tr("The picture"),
         tr("This is what a lesson is about. Drag anything in it, and let go on the way to throw it."),
         whole(m_scene)},
        {tr("Play and stop"),
         tr("**Space** plays, and stops anywhere. **→** goes on by one frame, **←** goes back."),
         whole(m_transport)},
        {tr("All of the run is kept"),
         tr("Drag here to go back in time. Change something there, and the old run stays as a ghost."),
         half(true)},
        {tr("Inside a frame"),
         tr("A frame is made of phases: springs pull, damping takes its share, things move. **Shift+→** goes "
            "from one to the next."),
         half(false)},
        {tr("The code that runs"),
         tr("These very lines compute the picture. Beside them stand the values of this moment."),
         whole(m_code)},
        {tr("Numbers to change"),
         tr("Move a slider, or type any number. The arrow behind it brings it back."), whole(m_parameters)},
        {tr("Try this"),
         tr("Springstep ticks what it sees you do. A lamp has a hint, and words with dots under them are "
            "explained when you click them."),
         whole(tries)},
    };
}

}
