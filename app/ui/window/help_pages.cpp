#include "app/ui/window/help_pages.h"

#include "app/model/session/session.h"
#include "app/ui/actions/command_list.h"
#include "app/ui/actions/gestures.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/help/about_page.h"
#include "app/ui/help/help_page.h"
#include "app/ui/learn/words/glossary_page.h"
#include "app/ui/map/map_page.h"

namespace app {

HelpPages::HelpPages(Session &session, const CommandList &commands, const Glossary &glossary,
                     const Theme &theme, QWidget &window)
    : m_session(session), m_commands(commands), m_glossary(glossary), m_theme(theme), m_window(window)
{
}

void HelpPages::showKeys()
{
    if (!m_keys) {
        m_keys = new HelpPage(m_theme, &m_window);
        for (const QString &title : groupTitles())
            m_keys->addGroup(title);
        for (const CommandList::Entry &entry : m_commands.entries())
            m_keys->addAction(titleOf(entry.group), entry.command);
        addGestures(*m_keys);
    }
    showInFront(*m_keys);
}

void HelpPages::showGlossary(const QString &typed)
{
    if (!m_glossaryPage) {
        m_glossaryPage = new GlossaryPage(m_glossary, m_theme, &m_window);
        QObject::connect(m_glossaryPage, &GlossaryPage::stepRequested, &m_session, &Session::openStep);
        m_session.onChange(ChangeKind::texts, m_glossaryPage, &GlossaryPage::refresh);
    }
    m_glossaryPage->search(typed);
}

void HelpPages::showMap()
{
    if (!m_map)
        m_map = new MapPage(m_session, m_theme, &m_window);
    m_map->showMap();
}

void HelpPages::showAbout()
{
    if (!m_about)
        m_about = new AboutPage(&m_window);
    m_about->open();
}

}
