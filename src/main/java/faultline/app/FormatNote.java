package faultline.app;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * A note on an output whose name ends as that of another format than the one that is written. It is no error, because
 * the file is complete, and scripts may rely on its name.
 */
final class FormatNote {

    /** The endings of formats that someone may expect of a picture, a film, a table or a page. */
    private static final Set<String> KNOWN = Set.of(
            "png", "apng", "svg", "svgz", "jpg", "jpeg", "gif", "bmp", "tif", "tiff", "webp", "avif", "eps", "ps",
            "pdf", "mp4", "m4v", "webm", "mkv", "mov", "avi", "mpg", "mpeg", "ogv", "html", "htm", "md", "txt", "csv",
            "tsv", "json", "xml", "xls", "xlsx", "ods", "doc", "docx", "odt", "gz", "zip");

    private FormatNote() {}

    /**
     * Returns the note on an output, or empty if there is nothing to say.
     *
     * @param file the output
     * @param format the format that is written, with its article
     * @param endings the endings of names that fit, in small letters
     */
    static Optional<String> of(Path file, String format, List<String> endings) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        String ending = name.substring(name.lastIndexOf('.') + 1);
        if (!name.contains(".") || endings.contains(ending) || !KNOWN.contains(ending)) {
            return Optional.empty();
        }
        return Optional.of(file + ": this is " + format + ", although the name ends with ." + ending
                + "; names with the ending ." + String.join(" or .", endings) + " fit");
    }
}
