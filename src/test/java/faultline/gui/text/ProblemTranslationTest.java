package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.campaign.plan.PlanProblem;
import faultline.campaign.run.ResultsProblem;
import faultline.engine.RunProblem;
import faultline.external.ControllerProblem;
import faultline.floorplan.FloorPlanProblem;
import faultline.io.Message;
import faultline.io.WriteProblem;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.ProblemKind;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The problems of files are translated from their data. The tests of scenario files check each sentence, too. */
class ProblemTranslationTest {

    private static final Pattern PLACEHOLDER = Pattern.compile("\\{\\d}");

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    private static Stream<Message.Template> templates() {
        return Stream.of(
                        ProblemKind.values(),
                        Allowed.values(),
                        WriteProblem.values(),
                        FloorPlanProblem.values(),
                        RunProblem.values(),
                        ControllerProblem.values(),
                        PlanProblem.values(),
                        ResultsProblem.values())
                .flatMap(Stream::of);
    }

    @ParameterizedTest
    @MethodSource("templates")
    void everyKindOfProblemHasTheSamePlaceholdersInAllLanguages(Message.Template template) {
        assertEquals(template.english(), Messages.get(Language.ENGLISH, template.key()));
        assertEquals(placeholders(template.english()), placeholders(Messages.get(Language.POLISH, template.key())));
    }

    @ParameterizedTest
    @EnumSource
    void everyProblemOfAFloorPlanIsInPolish(FloorPlanProblem problem) {
        assertNotEquals(problem.english(), Messages.get(Language.POLISH, problem.key()));
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "OTHER")
    void everyReasonWhyARunBreaksIsInPolish(RunProblem problem) {
        assertNotEquals(problem.english(), Messages.get(Language.POLISH, problem.key()));
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "OTHER")
    void everyProblemOfAControllerIsInPolish(ControllerProblem problem) {
        assertNotEquals(problem.english(), Messages.get(Language.POLISH, problem.key()));
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "IN_FILE")
    void everyProblemOfAPlanIsInPolish(PlanProblem problem) {
        assertNotEquals(problem.english(), Messages.get(Language.POLISH, problem.key()));
    }

    @ParameterizedTest
    @EnumSource
    void everyProblemOfResultsIsInPolish(ResultsProblem problem) {
        assertNotEquals(problem.english(), Messages.get(Language.POLISH, problem.key()));
    }

    private static List<String> placeholders(String pattern) {
        return PLACEHOLDER
                .matcher(pattern)
                .results()
                .map(found -> found.group())
                .sorted()
                .toList();
    }

    private static Stream<Arguments> translations() {
        List<String> kinds = List.of("off", "stuck");
        return Stream.of(
                Arguments.of(
                        ProblemKind.VALUE.with("kind", "fault", "stick", Allowed.names(kinds, "stick")),
                        "kind w <fault> to \"stick\"; dozwolone: off, stuck; czy chodziło o \"stuck\"?"),
                Arguments.of(
                        ProblemKind.VALUE.with(
                                "width",
                                "world",
                                "-6",
                                Allowed.NUMBER.with(Allowed.METRES.with(Allowed.CLOSED.with("0.000001", "100000")))),
                        "width w <world> to \"-6\"; dozwolone: liczba od 0.000001 do 100000 (metry)"),
                Arguments.of(
                        ProblemKind.VALUE.with("name", "x", "a number from 1 to 2", Allowed.NONE.with()),
                        "name w <x> to \"a number from 1 to 2\"; dozwolone: brak"),
                Arguments.of(
                        ProblemKind.VALUE.with("kind", "fault", "{0} it''s", Allowed.FLAG.with()),
                        "kind w <fault> to \"{0} it''s\"; dozwolone: true lub false"),
                Arguments.of(
                        ProblemKind.UNKNOWN_ELEMENT.with("world", "text", "circle"),
                        "<world> nie może zawierać <text>; dozwolone: circle"),
                Arguments.of(
                        ProblemKind.MALFORMED_AFTER_INSIDE.with("<a", "world", 3),
                        "to nie jest poprawny XML, za \"<a\", wewnątrz <world> z wiersza 3"),
                Arguments.of(
                        FloorPlanProblem.MISSPELT_KEY.with("resolution", "resolutoin"),
                        "brakuje \"resolution\"; być może \"resolutoin\" to błędna pisownia tej nazwy"),
                Arguments.of(
                        FloorPlanProblem.MISSING_NUMBER.with(FloorPlanProblem.PIXEL.with(2), 12),
                        "w bajcie 12 brakuje piksela 2"),
                Arguments.of(
                        FloorPlanProblem.WRONG_NUMBER.with(FloorPlanProblem.PIXEL.with(2), "x", 12),
                        "w bajcie 12 zamiast piksela 2 jest \"x\"; dozwolone: liczba całkowita"),
                Arguments.of(
                        ProblemKind.NOT_SAVED.with(ProblemKind.NOT_REPRODUCIBLE.with()),
                        "nie można zapisać scenariusza: zapisany plik dałby po wczytaniu inny scenariusz"));
    }

    private static Stream<Arguments> translationsOfCampaigns() {
        return Stream.of(
                Arguments.of(
                        PlanProblem.IN_WORLD.with(
                                ProblemKind.VALUE.with("value", "fault", "1.5", Allowed.FLAG.with()), "Yard"),
                        "value w <fault> to \"1.5\"; dozwolone: true lub false (świat: Yard)"),
                Arguments.of(
                        ResultsProblem.CELL.with("outcome", "\"won\"", ResultsProblem.ONE_OF.with("lost, stopped")),
                        "outcome to \"won\"; dozwolone: jedno z: lost, stopped"));
    }

    @ParameterizedTest
    @MethodSource({"translations", "translationsOfCampaigns"})
    void aProblemIsTranslatedExceptForTheUsersOwnText(Message message, String polish) {
        Messages.setLanguage(Language.POLISH);
        assertEquals(polish, Messages.get(message));
    }

    @Test
    void manyAllowedNamesAreShortened() {
        List<String> names =
                Stream.iterate(1, i -> i + 1).limit(14).map(i -> "s" + i).toList();
        assertEquals(
                "s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12 and 2 more", String.valueOf(Allowed.names(names)));
    }
}
