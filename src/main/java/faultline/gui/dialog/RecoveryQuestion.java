package faultline.gui.dialog;

import faultline.gui.document.FileNames;
import faultline.gui.document.RecoveryStore.RecoveredFile;
import faultline.gui.text.Messages;
import java.nio.file.Path;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The question whether edits are recovered after a crash. */
final class RecoveryQuestion {

    /** Digits from the year to the minute, which no language reads in another way. */
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm", Locale.ROOT);

    private RecoveryQuestion() {}

    /**
     * Returns the question with the time of the edits and the folder of their file, a line each, and the file that the
     * window shows, null for none, if the edits would replace it.
     */
    static String text(RecoveredFile recovered, Path shownFile) {
        List<String> lines = new ArrayList<>();
        lines.add(Messages.get("recover.question", recovered.name()));
        recovered
                .origin()
                .map(Path::getParent)
                .ifPresent(folder -> lines.add(Messages.get("recover.folder", folder.toString())));
        lines.add(
                Messages.get("recover.written", TIME.format(recovered.written().atZone(ZoneId.systemDefault()))));
        if (shownFile != null && !isOrigin(shownFile, recovered)) {
            lines.add(Messages.get("recover.instead", FileNames.lastOf(shownFile)));
        }
        return String.join("\n", lines);
    }

    private static boolean isOrigin(Path file, RecoveredFile recovered) {
        Path absolute = file.toAbsolutePath().normalize();
        return recovered.origin().map(Path::normalize).filter(absolute::equals).isPresent();
    }
}
