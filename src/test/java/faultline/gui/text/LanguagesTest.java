package faultline.gui.text;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.ShippedScenarios;
import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The texts of both languages correspond. */
class LanguagesTest {

    private static final Path FOLDER = Path.of("src/main/resources/faultline/gui");
    private static final Properties ENGLISH = read("Messages.properties");
    private static final Properties POLISH = read("Messages_pl.properties");
    private static final Pattern GAP = Pattern.compile("\\{\\d+}");
    private static final Pattern TAG = Pattern.compile("</?(?:h1|h2|p)>");

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void bothHaveTheSameKeys() {
        assertEquals(
                String.join("\n", new TreeSet<>(ENGLISH.stringPropertyNames())),
                String.join("\n", new TreeSet<>(POLISH.stringPropertyNames())));
    }

    @Test
    void everyTextHasTheSamePlaceholdersMnemonicsAndPartsInBoth() {
        List<String> unlike = keys().filter(key -> !form(ENGLISH, key).equals(form(POLISH, key)))
                .toList();
        assertEquals(List.of(), unlike);
    }

    @Test
    void aTextThatEndsWithAUnitDoesSoInBoth() {
        Pattern unit = Pattern.compile(", (?:m|s|°|V|°/s|m/s|m/s/V|rad/m|rad/s/m)$");
        List<String> without = keys().filter(
                        key -> unit.matcher(text(ENGLISH, key)).results().anyMatch(found -> !text(POLISH, key)
                                .endsWith(found.group())))
                .toList();
        assertEquals(List.of(), without);
    }

    @Test
    void quotesAreDoubledInTextsWithPlaceholders() {
        Pattern lone = Pattern.compile("(?<!')'(?!')");
        Stream.of(ENGLISH, POLISH)
                .forEach(language -> assertEquals(
                        List.of(),
                        keys().filter(key -> GAP.matcher(text(language, key)).find()
                                        && lone.matcher(text(language, key)).find())
                                .toList()));
    }

    @Test
    void textsAreTranslated() {
        List<String> same = keys().filter(key -> key.endsWith(".tip") && !key.equals("action.languagePolish.tip"))
                .filter(key -> text(ENGLISH, key).equals(text(POLISH, key)))
                .toList();
        assertEquals(List.of(), same);
    }

    /** See the glossary: the time line is a part of the window, the timeline one of the scenario. */
    @Test
    void timeLineAndTimelineHaveOnePolishTermEach() {
        Pattern timeLine = Pattern.compile("(?i)\\blini\\p{L} czasu");
        Pattern timeline = Pattern.compile("(?i)\\bo(?:ś|si|sią) czasu");
        keys().forEach(key -> {
            String english = ENGLISH.getProperty(key).toLowerCase(Locale.ROOT);
            String polish = POLISH.getProperty(key);
            assertEquals(english.contains("timeline"), timeline.matcher(polish).find(), key + "=" + polish);
            assertTrue(!timeLine.matcher(polish).find() || english.contains("time line"), key + "=" + polish);
        });
    }

    @Test
    void theGuideHasTheSameSectionsInBoth() {
        List<String> english = tags(Messages.loadPage("guide"));
        Messages.setLanguage(Language.POLISH);
        assertEquals(english, tags(Messages.loadPage("guide")));
        assertTrue(english.size() > 20);
    }

    @Test
    void everyExampleIsTranslatedAndNoOther() throws IOException {
        TreeSet<String> wanted = new TreeSet<>();
        for (String file : ShippedScenarios.names()) {
            wanted.add(file.replace(".xml", ".title"));
            wanted.add(file.replace(".xml", ".text"));
        }
        assertEquals(wanted, new TreeSet<>(read("Examples_pl.properties").stringPropertyNames()));
    }

    @Test
    void anUntranslatedExampleKeepsItsOwnText() {
        assertEquals("Office", Messages.exampleText("office.title", "Office"));
        Messages.setLanguage(Language.POLISH);
        assertEquals("Biuro", Messages.exampleText("office.title", "Office"));
        assertEquals("Mine", Messages.exampleText("mine.title", "Mine"));
    }

    @Test
    void theDefaultLanguageIsEnglish() {
        assertEquals("&File", Messages.get("menu.file"));
        Messages.setLanguage(Language.POLISH);
        assertEquals("&Plik", Messages.get("menu.file"));
    }

    @Test
    void swingDialogsUseTheLanguageToo() {
        Messages.setLanguage(Language.POLISH);
        runOnEdt(() -> {
            SwingMessages.install();
            assertEquals("Anuluj", UIManager.getString("OptionPane.cancelButtonText"));
            assertEquals("Otwórz", UIManager.getString("FileChooser.openButtonText"));
            assertEquals("Nazwa folderu:", UIManager.getString("FileChooser.folderNameLabelText"));
            assertEquals("Odśwież", UIManager.getString("FileChooser.refreshActionLabelText"));
            assertEquals("Nie można utworzyć folderu", UIManager.getString("FileChooser.newFolderErrorText"));
            assertEquals(
                    "Wszystkie pliki",
                    new JFileChooser().getAcceptAllFileFilter().getDescription());
        });
        Messages.setLanguage(Language.ENGLISH);
        runOnEdt(SwingMessages::install);
    }

    @Test
    void theHintOfAToolNamesItsKeys() {
        List<String> without = keys().filter(key -> key.matches("action\\.(place|draw|measure).*\\.tip"))
                .filter(key -> Stream.of(ENGLISH, POLISH)
                        .map(language -> text(language, key))
                        .anyMatch(hint -> !hint.matches(
                                key.contains("place")
                                        ? ".*(arrow keys|strzałek).* Enter"
                                        : ".*(arrow keys|strzałek).* Insert.* (Enter|Esc) .*")))
                .toList();
        assertEquals(List.of(), without);
    }

    private static Stream<String> keys() {
        return new TreeSet<>(ENGLISH.stringPropertyNames()).stream();
    }

    /** Returns what must be equal in both languages: placeholders, mnemonic, ellipsis, and the number of list items. */
    private static String form(Properties language, String key) {
        String text = text(language, key);
        TreeSet<String> gaps = new TreeSet<>(
                GAP.matcher(text).results().map(found -> found.group()).toList());
        return gaps + " " + text.contains("&") + " " + text.endsWith("…") + " "
                + text.chars().filter(letter -> letter == ';').count();
    }

    private static String text(Properties language, String key) {
        return language.getProperty(key, "");
    }

    private static List<String> tags(String page) {
        return TAG.matcher(page).results().map(found -> found.group()).toList();
    }

    private static Properties read(String name) {
        Properties texts = new Properties();
        try (Reader in = Files.newBufferedReader(FOLDER.resolve(name), StandardCharsets.UTF_8)) {
            texts.load(in);
        } catch (IOException unreadable) {
            throw new AssertionError(unreadable);
        }
        return texts;
    }
}
