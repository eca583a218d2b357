// A picture as WebP of this size, from a PNG of the same proportions.
export async function webp(browser, png, width, height) {
  const picture = await browser.blank.evaluate(async ([text, width, height]) => {
    const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]), { resizeWidth: width, resizeHeight: height, resizeQuality: "high" });
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d").drawImage(image, 0, 0);
    const blob = await canvas.convertToBlob({ type: "image/webp", quality: 0.82 });
    return String.fromCharCode(...new Uint8Array(await blob.arrayBuffer()));
  }, [png.toString("base64"), width, height]);
  return Buffer.from(picture, "latin1");
}
