// What the page does to itself: panel, full screen, the link to the clipboard.

export function toggle_panel(panel, opener, shown = document.body.classList.contains('no-panel')) {
  // Focus must not stay on something that is gone.
  const had_focus = panel.contains(document.activeElement);
  document.body.classList.toggle('no-panel', !shown);
  panel.inert = !shown;
  if (!shown && had_focus) opener.focus();
}

export function toggle_fullscreen() {
  return document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
}

// Resolves to what to tell. Without a secure context there is no clipboard: the address bar holds the same link.
export async function copy_link() {
  try {
    await navigator.clipboard.writeText(location.href);
    return 'Link copied';
  } catch {
    return 'The link is in the address bar';
  }
}
