package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.engine.RunFailedException;
import faultline.gui.text.Translations;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Bad children end the run in one sentence and leave no process. Several run at a time, because they mostly wait. */
@EnabledOnOs(
        value = {OS.LINUX, OS.MAC},
        disabledReason = "the children of this test are shell scripts")
class BadChildTest {

    private static final String READY = "echo '{\"type\":\"ready\",\"protocol\":1,\"name\":\"child\"}';";
    private static final String DRIVE = "echo '{\"type\":\"drive\",\"tick\":0,\"left_v\":1,\"right_v\":1}';";

    /** The time limit of a child that does not answer, seconds. */
    private static final double PATIENCE = 0.5;

    /** The time limit of one that does, so that a machine on which programs start slowly changes no result, seconds. */
    private static final double LONG = 50;

    private final ExecutorService runs = Executors.newFixedThreadPool(8);

    /** Says that a child or a process that it has started ends with its run. */
    private record Case(int number, String script, double start, double patience, String sentence) {

        /** Runs the child, whose command and whose process {@code sleep} contain the number of this case. */
        void check() {
            String pause = "." + (1000 + number);
            String text = script.replace("echo R;", READY)
                    .replace("echo D;", DRIVE)
                    .replaceAll("sleep ([56]0)", "sleep $1" + pause);
            String command = ExternalControllerTest.shell("case=" + pause + "; " + text);
            RunFailedException e = assertThrows(
                    RunFailedException.class,
                    () -> ExternalControllerTest.run(
                            command, ExternalControllerTest.office(), start, patience, line -> {}));
            assertEquals("the controller \"" + command + "\" " + sentence, e.getMessage());
            Translations.assertTranslated(e.reason());
            assertEquals(
                    List.of(),
                    ProcessHandle.current()
                            .descendants()
                            .map(process -> process.info().commandLine().orElse(""))
                            .filter(line -> line.contains(pause))
                            .toList());
        }
    }

    @AfterEach
    void close() {
        runs.shutdownNow();
    }

    @TestFactory
    Stream<DynamicTest> aBadChildEndsTheRunInOneSentence() {
        String cases =
                """
                read l; echo R; read l; echo hello | wrote no JSON at tick 0: "hello" (there is no value at character 1); write messages for people to standard error
                read l; echo R; read l; echo 7 | wrote no JSON object at tick 0: "7"
                read l; echo R; read l; echo '{"type":"dance"}' | wrote a message at tick 0 of type "dance"; expected "drive"
                read l; echo R; read l; echo '{"type":"dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd"}' | wrote a message at tick 0 of type "dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd..."; expected "drive"
                read l; echo R; read l; printf '{"state":"\\377"}\\n' | wrote a line at tick 0 that is not UTF-8: "{"state":"\uFFFD"}"
                read l; printf '\\357\\273\\277{}\\n' | wrote no JSON before the first tick: "\uFEFF{}" (there is a byte order mark at character 1); write messages for people to standard error
                read l; echo R; read l; echo '{"type":"drive","tick":5,"left_v":1,"right_v":1}' | answered tick 5 at tick 0; expected the tick of the observation
                read l; printf '{"type":"ready","protocol":1}\\n{"type":"drive","tick":0,"left_v":1,"right_v":1}\\n'; sleep 60 | answered at tick 0 before the observation was sent; expected an answer to each observation
                read l; echo R; read l; echo '{"type":"drive","tick":0,"left_v":1}' | wrote a message at tick 0 whose "right_v" is missing; expected a finite number
                read l; echo R; read l; echo '{"type":"drive","tick":0,"left_v":"1","right_v":1}' | wrote a message at tick 0 whose "left_v" is the string "1"; expected a finite number
                read l; echo R; read l; echo '{"type":"drive","tick":0,"left_v":1e999,"right_v":1}' | wrote a message at tick 0 whose "left_v" is the number 1e999; expected a finite number
                read l; echo R; read l; echo '{"type":"drive","tick":0}' | wrote a drive message at tick 0 with neither voltages nor velocities; expected either left_v and right_v or v_m_s and omega_rad_s
                read l; echo R; read l; exit 7 | ended with exit code 7 at tick 0
                read l; echo R; read l; printf '{"type":'; exit 0 | ended with exit code 0 at tick 0 in the middle of a line
                read l; echo R; read l; sleep 60 | has not answered for 0.5 s at tick 0
                read l; echo R; read l; printf '{"type":'; sleep 60 | has not answered for 0.5 s at tick 0; its last line has no end
                read l; echo R; read l; head -c 2000000 /dev/zero 2>&-; sleep 60 | wrote a line of more than 1000000 bytes at tick 0; expected shorter ones
                read l; echo '{"type":"ready","protocol":2}' | speaks protocol 2 before the first tick; expected 1
                read l; echo R; read l; exec 0<&-; sleep 60 | has not answered for 0.5 s at tick 0
                read l; echo R; read l; sleep 0.2; echo '{"type":"drive","tick":0,"left_v":NaN,"right_v":1}' | wrote no JSON at tick 0: "{"type":"drive","tick":0,"left_v":NaN,"right_v":1}" (NaN is no number in JSON at character 35); write messages for people to standard error
                sleep 60 | has not answered for 0.5 s before the first tick; a program must flush its standard output after each line
                exit 3 | ended with exit code 3 before the first tick
                exit 0 | ended with exit code 0 before the first tick; it must answer until the run has ended, as drive_with of the Python client does
                """;
        List<Case> parsed = new ArrayList<>();
        for (String line : cases.split("\n")) {
            String[] cells = line.split("\\|");
            String sentence = cells[1].strip();
            double start = sentence.contains(" 0.5 s before the first tick") ? PATIENCE : LONG;
            double patience = sentence.contains(" 0.5 s ") ? PATIENCE : LONG;
            parsed.add(new Case(parsed.size(), cells[0].strip(), start, patience, sentence));
        }
        return checkAll(parsed);
    }

    @TestFactory
    Stream<DynamicTest> theEndOfAChildsOutputIsFoundWhileItIsSilent() {
        String cases =
                """
                read l; exec 1>&-; sleep 50 | Infinity | closed its standard output before the first tick
                read l; echo R; read l; exec 1>&-; sleep 50 | Infinity | closed its standard output at tick 0
                read l; echo R; read l; printf '{'; exec 1>&-; sleep 50 | Infinity | closed its standard output at tick 0 in the middle of a line
                read l; echo R; read l; sleep 2; exec 1>&-; sleep 50 | Infinity | closed its standard output at tick 0
                read l; echo R; read l; sleep 2; echo D; exec 1>&-; sleep 50 | Infinity | closed its standard output at tick 1
                read l; echo R; read l; sleep 2; exit 7 | Infinity | ended with exit code 7 at tick 0
                sleep 50 & read l; echo R; read l; sleep 2; exit 7 | Infinity | ended with exit code 7 at tick 0
                sleep 50 & read l; echo R; read l; sleep 2; echo D; exit 7 | Infinity | ended with exit code 7 at tick 1
                read l; echo R; read l; sleep 50 | 2 | has not answered for 2.0 s at tick 0
                """;
        List<Case> parsed = new ArrayList<>();
        for (String line : cases.split("\n")) {
            String[] cells = line.split("\\|");
            double patience = Double.parseDouble(cells[1].strip());
            parsed.add(new Case(parsed.size(), cells[0].strip(), LONG, patience, cells[2].strip()));
        }
        return checkAll(parsed);
    }

    /** Starts to check all cases, and returns a test for the result of each. */
    private Stream<DynamicTest> checkAll(List<Case> cases) {
        List<DynamicTest> tests = new ArrayList<>();
        for (Case next : cases) {
            Future<?> result = runs.submit(next::check);
            tests.add(DynamicTest.dynamicTest(next.sentence(), () -> result.get(300, TimeUnit.SECONDS)));
        }
        return tests.stream();
    }
}
