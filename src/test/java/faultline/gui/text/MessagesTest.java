package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.control.SensorFinding;
import faultline.gui.document.TaskKind;
import faultline.robot.MotorFaultKind;
import faultline.sensor.FaultKind;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class MessagesTest {

    private static final Pattern TEXT =
            Pattern.compile("(?:Messages\\.get|Messages\\.contains|cell|label|name|addRow)\\((?:"
                    + "\\d, |\\w+, )?\"([a-z]\\w*\\.[\\w.]+\\w)\"");
    private static final Pattern ACTION = Pattern.compile("(?:UiAction\\.(?:of|toggle)|layer|rename)\\(\"(\\w+)\"");

    @Test
    void everyTextThatTheWindowAsksForIsThere() throws IOException {
        TreeSet<String> missing = new TreeSet<>();
        int asked = 0;
        for (String source : sources()) {
            List<String> keys =
                    TEXT.matcher(source).results().map(found -> found.group(1)).toList();
            asked += keys.size();
            keys.stream().filter(key -> !Messages.contains(key)).forEach(missing::add);
        }
        assertEquals(List.of(), List.copyOf(missing));
        assertTrue(asked > 60, "only " + asked + " found");
    }

    @Test
    void everyActionHasANameAndATip() throws IOException {
        TreeSet<String> missing = new TreeSet<>();
        int asked = 0;
        for (String source : sources()) {
            for (String key : ACTION.matcher(source)
                    .results()
                    .map(found -> "action." + found.group(1))
                    .toList()) {
                asked++;
                Stream.of(key, key + ".tip")
                        .filter(each -> !Messages.contains(each) && !each.startsWith("action.sensor"))
                        .forEach(missing::add);
            }
        }
        assertEquals(List.of(), List.copyOf(missing));
        assertTrue(asked > 20, "only " + asked + " found");
    }

    @Test
    void everyKindOfFaultAndEveryTaskHasAText() {
        Stream.of(FaultKind.values())
                .forEach(kind -> assertTrue(Messages.contains("fault." + kind.fileName()), kind.fileName()));
        Stream.concat(Stream.of(FaultKind.values()), Stream.of(MotorFaultKind.values()))
                .forEach(kind -> {
                    assertFalse(FaultText.describe(kind).isBlank(), kind.fileName());
                    assertTrue(Messages.contains(FaultText.valueKeyOf(kind)), kind.fileName());
                });
        Stream.of(TaskKind.values()).forEach(task -> assertTrue(Messages.contains("failed." + task), task.name()));
    }

    @Test
    void noTextIsDefinedTwice() throws IOException {
        for (String file : List.of("Messages.properties", "Messages_pl.properties")) {
            List<String> keys = Files.readAllLines(
                            Path.of("src/main/resources/faultline/gui").resolve(file))
                    .stream()
                    .filter(line -> line.matches("[A-Za-z].*=.*"))
                    .map(line -> line.substring(0, line.indexOf('=')))
                    .toList();
            assertEquals(new TreeSet<>(keys).size(), keys.size(), file);
        }
    }

    @Test
    void noTextNamesAStateByItsIdentifier() throws IOException {
        String states =
                Stream.of(FollowerState.values()).map(FollowerState::name).collect(Collectors.joining("|"));
        Pattern identifier = Pattern.compile("[\\w.]+=.*\\b(" + states + ")\\b.*");
        List<String> named = new ArrayList<>();
        for (String file : List.of("Messages.properties", "Messages_pl.properties")) {
            Files.readAllLines(Path.of("src/main/resources/faultline/gui").resolve(file)).stream()
                    .filter(line -> identifier.matcher(line).matches())
                    .forEach(named::add);
        }
        assertEquals(List.of(), named);
    }

    @Test
    void aRungThatIsNoneOfTheLadderKeepsTheNameThatItsControllerGivesIt() {
        assertEquals("Two sensors", HealthText.rung("TWO"));
        assertEquals("5 of 6: one sensor, map", HealthText.rungPosition("ONE"));
        assertEquals("limp", HealthText.rung("limp"));
        assertEquals("limp", HealthText.rungPosition("limp"));
    }

    @Test
    void aDistrustedSensorHasItsReasonInASentence() {
        assertEquals("its reading does not change", HealthText.reason(SensorFinding.STUCK));
        assertEquals("", HealthText.reason(SensorFinding.NONE));
    }

    @Test
    void placeholdersAreReplacedLiterally() {
        assertEquals("1234.5 to 2", Messages.get("number.limits", "1234.5", "2"));
    }

    private static List<String> sources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java/faultline/gui"))) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .map(MessagesTest::read)
                    .toList();
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException unreadable) {
            throw new AssertionError(unreadable);
        }
    }
}
