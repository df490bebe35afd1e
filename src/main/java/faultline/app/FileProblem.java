package faultline.app;

import faultline.io.WriteProblem;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Why a file or a folder cannot be used. The operating system gives its reasons in the language of the user. */
final class FileProblem {

    private FileProblem() {}

    /** Returns the reason of a failure that names its file, which follows that name. */
    static String reason(FileSystemException e) {
        if (e instanceof NoSuchFileException) {
            return "there is no such file";
        }
        if (e instanceof AccessDeniedException) {
            return "access is denied";
        }
        Path file = Path.of(e.getFile()).toAbsolutePath();
        if (e instanceof FileAlreadyExistsException) {
            return Files.isSymbolicLink(file)
                    ? "this link does not lead to a folder; expected a folder"
                    : "this is a file; expected a folder";
        }
        Path existing = existingPart(file);
        if (!existing.equals(file) && !Files.isDirectory(existing)) {
            return "a part of this path is a file; expected a folder";
        }
        if (isReadOnly(existing)) {
            return "its file system is read-only";
        }
        if (WriteProblem.isTooLong(file, e)) {
            return WriteProblem.NAME_TOO_LONG.english();
        }
        return e.getReason() == null ? "the file cannot be used" : e.getReason();
    }

    /** Returns the longest beginning of a path that exists. */
    private static Path existingPart(Path file) {
        Path part = file;
        while (!Files.exists(part) && part.getParent() != null) {
            part = part.getParent();
        }
        return part;
    }

    private static boolean isReadOnly(Path existing) {
        try {
            return Files.getFileStore(existing).isReadOnly();
        } catch (IOException unknown) {
            return false;
        }
    }
}
