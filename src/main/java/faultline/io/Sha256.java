package faultline.io;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** The hash by which files are recognised (FIPS 180-4). */
public final class Sha256 {

    private Sha256() {}

    /**
     * {@return the SHA-256 of some bytes, as 64 hexadecimal digits in lower case}
     *
     * @param bytes the content of a file
     */
    public static String hex(byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }
}
