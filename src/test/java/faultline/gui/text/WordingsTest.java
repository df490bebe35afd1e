package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
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
class WordingsTest {

    private static final Pose ROBOT = new Pose(2, 2, 0);
    private static final Obstacle POLE = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(4, 2, 0));

    private static final Pattern ENGLISH = Pattern.compile("\\b(is|allowed|the|of|from|than|number|holds|has|one|or|and|metres|seconds)\\b");

    @AfterEach
    void speakEnglish() {
        Texts.speak(Language.ENGLISH);
    }

    private static List<Command> refused() {
        Motion way = new Motion(0.1, true, List.of(new Vec(4, 3)));
        return List.of(new Command.PutObstacle(POLE.at(ROBOT)), new Command.SetPlatform(9, 9, 0.3),
                new Command.PutObstacle(POLE.moving(Optional.of(way))), new Command.RemoveObstacle("sofa"),
                new Command.SwitchSensor("nose", true), new Command.ClearFault("left", new Fault.Dead()),
                new Command.PutObstacle(POLE.named(WorldSpec.ENCLOSURE)));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void everyReasonOfTheWorldIsKnown(Command command) {
        String reason = new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, ROBOT, 0.01, 1).apply(command).orElseThrow();
        assertEquals(reason, Wordings.text(reason), "in English as it is");
        Texts.speak(Language.POLISH);
        assertNotEquals(reason, Wordings.text(reason));
    }

    @Test
    void aReasonOfAnotherWordingStaysAsItIs() {
        assertEquals("the sky fell", Wordings.text("the sky fell"));
    }

    /**
     * The sentences of {@code ComplaintsTest}, which holds one for each mistake that a file can have, and of {@code HostileFilesTest}, which
     * has those about whole files.
     */
    private static Stream<String> complaints() throws IOException {
        return Stream.concat(sentences("ComplaintsTest", "\\| *\\d+:\\d+: (\\S.+)"),
                sentences("HostileFilesTest", "\"(?:\\w+\\.xml[:\\d]*: )?((?:the|there|this|<world>) [^\"\\\\]+)\"[,;)]")).distinct();
    }

    private static Stream<String> sentences(String test, String pattern) throws IOException {
        Pattern sentence = Pattern.compile(pattern);
        return Files.readAllLines(Path.of("src/test/java/faultline/scenario", test + ".java")).stream().map(sentence::matcher)
                .filter(Matcher::find).map(found -> found.group(1).strip());
    }

    @Test
    void theSentencesAboutWholeFilesAreFound() throws IOException {
        assertTrue(complaints().toList().containsAll(List.of("there is no such file", "the file has a DOCTYPE, allowed is none",
                "<world> holds too much, allowed is 100000 obstacles and points together")), complaints().toList().toString());
    }

    @ParameterizedTest
    @MethodSource("complaints")
    void everyComplaintAboutAFileIsKnownToItsLastWord(String complaint) {
        assertEquals(complaint, Wordings.text(complaint), "in English as it is");
        Texts.speak(Language.POLISH);
        String polish = Wordings.text(complaint);
        assertNotEquals(complaint, polish);
        String own = polish.replaceAll("\"[^\"]*\"|<[^>]*>", "");
        assertFalse(ENGLISH.matcher(own).find(), polish);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            kind of <fault> is "stick", allowed is off, stuck; did you mean "stuck"? | kind w <fault> to "stick", dozwolone: off, stuck; czy chodziło o "stuck"?
            width of <world> is "-6", allowed is a number from 0.000001 to 100000 metres | width w <world> to "-6", dozwolone: liczba od 0.000001 do 100000 (metry)
            kind of <fault> is "a", allowed is "b", allowed is off, stuck; did you mean "stuck"? | kind w <fault> to "a", allowed is "b", dozwolone: off, stuck; czy chodziło o "stuck"?
            name of <x> is "a number from 1 to 2", allowed is none | name w <x> to "a number from 1 to 2", dozwolone: brak
            there is no obstacle none | nie ma przeszkody none
            <world> may not hold <text>, allowed is circle | <world> nie może zawierać <text>, dozwolone: circle
            this is not well-formed XML, after "<a", inside <world> of line 3 | to nie jest poprawny XML, za "<a", wewnątrz <world> z wiersza 3
            the scenario cannot be saved: it would not read back the same | nie można zapisać scenariusza: po wczytaniu byłby inny
            """)
    void aComplaintIsTranslatedPhraseByPhraseButNotWhatTheUserWrote(String said, String polish) {
        Texts.speak(Language.POLISH);
        assertEquals(polish, Wordings.text(said));
    }
}
