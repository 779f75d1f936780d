#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/film_file.h"

namespace bullet_buoyancy::tests {
namespace {

using Arguments = std::vector<std::string>;

constexpr int interrupted = 130;

/// A demo that runs by itself; what it prints is read from a file descriptor.
class RunningDemo {
public:
    enum class Output {
        terminal,  ///< standard output and error are a terminal
        pipe,      ///< standard error is a pipe, and output goes nowhere
    };

    RunningDemo(const std::string& demo, const Arguments& arguments, Output output) {
        std::string program = std::string(BUOYANCY_DEMOS) + '/' + demo;
        std::vector<std::string> words = arguments;
        std::vector<char*> argv{program.data()};
        for (std::string& word : words)
            argv.push_back(word.data());
        argv.push_back(nullptr);
        if (output == Output::terminal) {
            m_process = forkpty(&m_read, nullptr, nullptr, nullptr);
            if (m_process == 0) execute(argv);
            return;
        }
        int ends[2];
        if (pipe(ends) != 0) return;
        m_process = fork();
        if (m_process == 0) {
            dup2(ends[1], STDERR_FILENO);
            if (!std::freopen("/dev/null", "w", stdout)) _exit(127);
            execute(argv);
        }
        close(ends[1]);
        m_read = ends[0];
    }

    ~RunningDemo() {
        if (!m_isOver) kill(m_process, SIGKILL), waitpid(m_process, nullptr, 0);
        close(m_read);
    }
    RunningDemo(const RunningDemo&) = delete;
    RunningDemo& operator=(const RunningDemo&) = delete;

    /// Reads until it has printed this. False if it ends without.
    bool awaitText(const std::string& text) {
        while (m_text.find(text) == std::string::npos)
            if (!read()) return false;
        return true;
    }

    void signal(int number) const { kill(m_process, number); }

    /// Its exit status; -1 if it did not exit by itself.
    int awaitEnd() {
        while (read()) {
        }
        int status = 0;
        waitpid(m_process, &status, 0);
        m_isOver = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    const std::string& text() const { return m_text; }

private:
    [[noreturn]] static void execute(const std::vector<char*>& argv) {
        execv(argv[0], argv.data());
        _exit(127);
    }

    /// False when there is no more to come; a terminal tells so by an error.
    bool read() {
        char buffer[4096];
        const ssize_t length = ::read(m_read, buffer, sizeof buffer);
        if (length <= 0) return false;
        m_text.append(buffer, std::size_t(length));
        return true;
    }

    pid_t m_process = -1;
    int m_read = -1;
    bool m_isOver = false;
    std::string m_text;
};

std::string fileOf(const std::string& name) {
    return testing::TempDir() + "buoyancy_" + name;
}

/// Commas that part fields.
int commasIn(const std::string& line) {
    int commas = 0;
    bool isQuoted = false;
    for (char c : line) {
        isQuoted ^= c == '"';
        commas += c == ',' && !isQuoted;
    }
    return commas;
}

/// A line of headers, and as many fields in each line after it. Returns how many those are.
int checkCsv(const std::string& file) {
    std::ifstream csv(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(csv), {}};
    EXPECT_FALSE(text.empty()) << file;
    if (text.empty()) return 0;
    EXPECT_EQ(text.back(), '\n') << file;
    std::istringstream lines(text);
    std::string headers, line;
    std::getline(lines, headers);
    int count = 0;
    for (; std::getline(lines, line); ++count)
        EXPECT_EQ(commasIn(line), commasIn(headers)) << file << ": " << line;
    return count;
}

TEST(LongWork, ShowsItsProgressOnATerminal) {
    RunningDemo demo("boat_in_waves", {"--duration", "35940"}, RunningDemo::Output::terminal);
    EXPECT_TRUE(demo.awaitText("s left")) << demo.text();
    EXPECT_NE(demo.text().find(" of 36000 s, "), std::string::npos) << demo.text();  // from the release on
    EXPECT_NE(demo.text().find(" simulated s/s, "), std::string::npos) << demo.text();
    demo.signal(SIGINT);
    EXPECT_EQ(demo.awaitEnd(), interrupted);
}

TEST(LongWork, IsQuietInAPipe) {
    RunningDemo demo("boat_in_waves", {"--duration", "36000"}, RunningDemo::Output::pipe);
    std::this_thread::sleep_for(std::chrono::seconds(2));  // on a terminal there would be a line by then
    demo.signal(SIGTERM);
    EXPECT_EQ(demo.awaitEnd(), interrupted);
    EXPECT_EQ(demo.text(), "boat_in_waves: interrupted\n");
}

/// A voyage that does not end, in a sea that asks little, released shortly before its record begins.
const Arguments longVoyage{"--duration", "36000", "--sea", "airy", "--tp", "0.5", "--hs", "0.01"};

/// A demo with more to do than anyone waits for.
struct LongDemo {
    const char* name;
    Arguments arguments;
    bool isFilmed;  ///< as it goes, not afterwards
    bool hasTable = true;
};

void PrintTo(const LongDemo& demo, std::ostream* out) {
    *out << demo.name;
}

class InterruptedDemo : public testing::TestWithParam<LongDemo> {};

TEST_P(InterruptedDemo, LeavesSoundFiles) {
    const std::string name = GetParam().name, csv = fileOf(name + ".csv"), film = fileOf(name + ".glb");
    std::remove(csv.c_str());
    std::remove(film.c_str());
    Arguments arguments = GetParam().arguments;
    arguments.insert(arguments.end(), {"--record", film});
    if (GetParam().hasTable) arguments.insert(arguments.end(), {"--csv", csv});

    RunningDemo demo(name, arguments, RunningDemo::Output::terminal);
    EXPECT_TRUE(demo.awaitText("%, ")) << demo.text();
    demo.signal(SIGINT);
    EXPECT_EQ(demo.awaitEnd(), interrupted) << demo.text();
    EXPECT_NE(demo.text().find(name + ": interrupted"), std::string::npos) << demo.text();
    if (GetParam().hasTable) checkCsv(csv);
    if (!GetParam().isFilmed) return;
    const FilmFile file(film);
    ASSERT_TRUE(file.isRead()) << file.error();
    ASSERT_NE(file.animation(), nullptr);
    EXPECT_GT(file.animation()->mDuration, 0);
}

INSTANTIATE_TEST_SUITE_P(LongWork, InterruptedDemo,
                         testing::Values(LongDemo{"boat_in_waves", longVoyage, true},
                                         LongDemo{"floating_cube", {"--ratio-step", "0.001"}, true},
                                         LongDemo{"flotsam", {"--duration", "100000"}, true, false},
                                         LongDemo{"hard_cases", {}, false},
                                         LongDemo{"rotation_schemes", {"--block", "100000"}, false},
                                         LongDemo{"soak", {"--bodies", "5"}, true, false},
                                         LongDemo{"speed_vs_error", {}, false},
                                         LongDemo{"step_cost", {"--steps", "10000"}, false},
                                         LongDemo{"wave_accuracy", {"--poses", "10000"}, false},
                                         LongDemo{"wave_cost", {"--rounds", "1000"}, false}),
                         [](const auto& demo) { return std::string(demo.param.name); });

TEST(LongWork, WritesTheSeriesUpToTheInterruption) {
    const std::string csv = fileOf("series.csv");
    Arguments arguments = longVoyage;
    arguments.insert(arguments.end(), {"--csv", csv});
    RunningDemo demo("boat_in_waves", arguments, RunningDemo::Output::terminal);
    ASSERT_TRUE(demo.awaitText(" simulated s/s, ")) << demo.text();
    demo.signal(SIGINT);
    EXPECT_EQ(demo.awaitEnd(), interrupted);
    EXPECT_GT(checkCsv(csv), 60);  // a second of the record
    EXPECT_LT(checkCsv(csv), 36000 * 60);
}

}  // namespace
}  // namespace bullet_buoyancy::tests
