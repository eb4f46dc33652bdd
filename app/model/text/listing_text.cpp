#include "app/model/text/listing_text.h"

namespace app {

QString listingSentence(const std::string &sentence)
{
    return QString::fromStdString(sentence);
}

}
