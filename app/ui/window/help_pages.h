#pragma once

#include "app/ui/theme/theme.h"

class QWidget;

namespace app {

class AboutPage;
class CommandList;
class Glossary;
class GlossaryPage;
class HelpPage;
class MapPage;
class Session;

/// The dialogs of the Help menu. Each is made when it is shown first.
class HelpPages
{
public:
    /// The dialogs belong to `window`. All arguments must outlive it.
    HelpPages(Session &session, const CommandList &commands, const Glossary &glossary, const Theme &theme,
              QWidget &window);

    /// Shows all keys and mouse gestures.
    void showKeys();
    /// Shows the glossary, with the words that match `typed` first.
    void showGlossary(const QString &typed);
    /// Shows the map of concepts.
    void showMap();
    void showAbout();

private:
    Session &m_session;
    const CommandList &m_commands;
    const Glossary &m_glossary;
    const Theme &m_theme;
    QWidget &m_window;
    HelpPage *m_keys = nullptr;
    GlossaryPage *m_glossaryPage = nullptr;
    MapPage *m_map = nullptr;
    AboutPage *m_about = nullptr;
};

}
