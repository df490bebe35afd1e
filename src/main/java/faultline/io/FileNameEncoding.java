package faultline.io;

import java.io.File;
import java.nio.charset.Charset;
import java.util.Optional;

/** The encoding of the names of files and of commands, which is that of the locale. */
public final class FileNameEncoding {

    private static final String ENCODING = System.getProperty("sun.jnu.encoding", "UTF-8");

    private FileNameEncoding() {}

    /** {@return whether names may have any character} */
    public static boolean isUnicode() {
        return ENCODING.equals("UTF-8");
    }

    /**
     * {@return the name of the encoding if it is the reason why something cannot have a name}
     *
     * @param name the name
     */
    public static Optional<String> lacking(String name) {
        boolean isLimited = File.separatorChar == '/' && !isUnicode() && Charset.isSupported(ENCODING);
        return isLimited && !Charset.forName(ENCODING).newEncoder().canEncode(name)
                ? Optional.of(ENCODING)
                : Optional.empty();
    }
}
