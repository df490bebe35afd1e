package faultline.gui.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.settings.WindowPreferences.PreferenceStore;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.prefs.Preferences;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The list of recently opened files. */
class RecentFilesTest {

    private final Map<String, String> texts = new HashMap<>();
    private final RecentFiles recent =
            new WindowPreferences(new PreferenceStore(key -> texts.getOrDefault(key, ""), this::put)).recentFiles();

    private void put(String key, String text) {
        assertTrue(text.length() <= Preferences.MAX_VALUE_LENGTH, "the preferences would refuse it");
        texts.put(key, text);
    }

    private static Path file(String name) {
        return Path.of(name).toAbsolutePath();
    }

    @Test
    void theEightNewestFilesAreKeptWithoutDuplicates() {
        IntStream.range(0, 10).forEach(i -> recent.add(file("room" + i)));
        recent.add(file("room5"));
        assertEquals(
                IntStream.of(5, 9, 8, 7, 6, 4, 3, 2)
                        .mapToObj(i -> file("room" + i))
                        .toList(),
                recent.files());
    }

    /** Systems whose names cannot have line breaks have no such files. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aNameWithALineBreakDoesNotBecomeTwoFiles() {
        recent.add(file("room"));
        recent.add(file("two\nlines"));
        recent.add(file("end\r"));
        assertEquals(List.of(file("room")), recent.files());
    }

    /** The platform stores preferences as XML and could read none of them again. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aNameThatXmlCannotHoldIsNotKept() {
        recent.add(file("room"));
        recent.add(file("a\u0001b"));
        assertEquals(List.of(file("room")), recent.files());
        RecentTexts commands = new WindowPreferences(new PreferenceStore(key -> texts.getOrDefault(key, ""), this::put))
                .recentCommands();
        for (String command : List.of("python \ud83d\ude00.py", "a\u0007b", "a\ud800b", "\udc00", "a\ufffe")) {
            commands.add(command);
        }
        assertEquals(List.of("python \ud83d\ude00.py"), commands.texts());
    }

    @Test
    void longNamesLeaveRoomForFewerFiles() {
        IntStream.range(0, 8).forEach(i -> recent.add(file(i + "x".repeat(200) + "/y".repeat(1000))));
        List<Path> files = recent.files();
        assertEquals(file("7" + "x".repeat(200) + "/y".repeat(1000)), files.get(0));
        assertTrue(files.size() >= 2 && files.size() < 8, files.size() + " files");
    }

    @Test
    void aNameThatIsTooLongLeavesTheOthers() {
        recent.add(file("room"));
        recent.add(file("x".repeat(9000)));
        assertEquals(List.of(file("room")), recent.files());
    }
}
