#pragma once

#include <map>
#include <stdexcept>
#include <string>

namespace sim {

/// A user error: input that composing or loading rejects. The app turns `id` and `values` into a sentence for
/// the user; what() is for developers.
class Error : public std::runtime_error
{
public:
    Error(std::string id, std::map<std::string, std::string> values)
        : std::runtime_error(describe(id, values)), m_id(std::move(id)), m_values(std::move(values))
    {
    }
    const std::string &id() const { return m_id; }
    const std::map<std::string, std::string> &values() const { return m_values; }

private:
    static std::string describe(const std::string &id, const std::map<std::string, std::string> &values)
    {
        std::string text = id;
        for (const auto &[name, value] : values)
            text += " " + name + "=" + value;
        return text;
    }

    std::string m_id;
    std::map<std::string, std::string> m_values;
};

}
