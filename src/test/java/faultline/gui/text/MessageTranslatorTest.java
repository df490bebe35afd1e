package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever the world refuses and whatever is wrong with a file, a Pole is told in Polish. */
class MessageTranslatorTest {

    private static final Pose ROBOT = new Pose(2, 2, 0);
    private static final Obstacle POLE = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(4, 2, 0));

    private static final Pattern ENGLISH =
            Pattern.compile("\\b(is|allowed|the|of|from|than|number|holds|has|one|or|and|metres|seconds)\\b");

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    private static List<Command> refusedCommands() {
        WaypointPath way = new WaypointPath(0.1, true, List.of(new Vector2(4, 3)));
        return List.of(
                new Command.PlaceObstacle(POLE.withPose(ROBOT)),
                new Command.SetPlatform(9, 9, 0.3),
                new Command.PlaceObstacle(POLE.withMotion(Optional.of(way))),
                new Command.RemoveObstacle("sofa"),
                new Command.SwitchSensor("nose", true),
                new Command.ClearFault("left", new Fault.Dead()),
                new Command.PlaceObstacle(POLE.withId(WorldSpec.ENCLOSURE)));
    }

    @ParameterizedTest
    @MethodSource("refusedCommands")
    void everyRefusalHasATranslation(Command command) {
        String reason = new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, ROBOT, 0.01, 1)
                .execute(command)
                .orElseThrow();
        assertEquals(reason, MessageTranslator.translate(reason), "in English as it is");
        Messages.setLanguage(Language.POLISH);
        assertNotEquals(reason, MessageTranslator.translate(reason));
    }

    @Test
    void anUnknownSentenceIsUnchanged() {
        assertEquals("the sky fell", MessageTranslator.translate("the sky fell"));
    }

    /**
     * The sentences of {@code ProblemsTest}, which holds one for each mistake that a file can have, and of
     * {@code HostileFilesTest}, which has those about whole files.
     */
    private static Stream<String> problemSentences() throws IOException {
        return Stream.concat(
                        sentences("ComplaintsTest", "\\| *\\d+:\\d+: (\\S.+)"),
                        sentences(
                                "HostileFilesTest",
                                "\"(?:\\w+\\.xml[:\\d]*: )?((?:the|there|this|<world>) [^\"\\\\]+)\"[,;)]"))
                .distinct();
    }

    private static Stream<String> sentences(String test, String pattern) throws IOException {
        Pattern sentence = Pattern.compile(pattern);
        return Files.readAllLines(Path.of("src/test/java/faultline/scenario", test + ".java")).stream()
                .map(sentence::matcher)
                .filter(Matcher::find)
                .map(found -> found.group(1).strip());
    }

    @Test
    void theSentencesAboutWholeFilesAreFound() throws IOException {
        assertTrue(
                problemSentences()
                        .toList()
                        .containsAll(List.of(
                                "there is no such file",
                                "the file has a DOCTYPE, allowed is none",
                                "<world> holds too much, allowed is 100000 obstacles and points together")),
                problemSentences().toList().toString());
    }

    @ParameterizedTest
    @MethodSource("problemSentences")
    void everyFileProblemIsTranslatedCompletely(String complaint) {
        assertEquals(complaint, MessageTranslator.translate(complaint), "in English as it is");
        Messages.setLanguage(Language.POLISH);
        String polish = MessageTranslator.translate(complaint);
        assertNotEquals(complaint, polish);
        String own = polish.replaceAll("\"[^\"]*\"|<[^>]*>", "");
        assertFalse(ENGLISH.matcher(own).find(), polish);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            kind of <fault> is "stick", allowed is off, stuck; did you mean "stuck"? | kind w <fault> to "stick", dozwolone: off, stuck; czy chodziło o "stuck"?
            width of <world> is "-6", allowed is a number from 0.000001 to 100000 metres | width w <world> to "-6", dozwolone: liczba od 0.000001 do 100000 (metry)
            kind of <fault> is "a", allowed is "b", allowed is off, stuck; did you mean "stuck"? | kind w <fault> to "a", allowed is "b", dozwolone: off, stuck; czy chodziło o "stuck"?
            name of <x> is "a number from 1 to 2", allowed is none | name w <x> to "a number from 1 to 2", dozwolone: brak
            there is no obstacle none | nie ma przeszkody none
            <world> may not hold <text>, allowed is circle | <world> nie może zawierać <text>, dozwolone: circle
            this is not well-formed XML, after "<a", inside <world> of line 3 | to nie jest poprawny XML, za "<a", wewnątrz <world> z wiersza 3
            the scenario cannot be saved: it would not read back the same | nie można zapisać scenariusza: po wczytaniu byłby inny
            """)
    void aProblemIsTranslatedExceptForQuotedInput(String said, String polish) {
        Messages.setLanguage(Language.POLISH);
        assertEquals(polish, MessageTranslator.translate(said));
    }
}
